// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_face.hpp"

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_eyes.hpp"
#include "facies/anatomy/builtin_jaw.hpp"
#include "facies/anatomy/builtin_lengths.hpp"
#include "facies/anatomy/builtin_lines.hpp"
#include "facies/anatomy/builtin_muscles.hpp"
#include "facies/anatomy/builtin_options.hpp"
#include "facies/anatomy/builtin_shape.hpp"
#include "facies/anatomy/builtin_supports.hpp"
#include "facies/anatomy/builtin_tissue.hpp"
#include "facies/anatomy/contact_regions.hpp"
#include "facies/anatomy/skin_axes.hpp"

namespace facies::anatomy {
namespace {

/// Between tissue and the bone that it lies on [mm]: the distance from which contact is felt.
constexpr double gap_to_bone = 1.0;

std::vector<Vec3> warped(const PointMap& warp, const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& x : points)
    result.push_back(warp(x));
  return result;
}

/// The surfaces of all bones, moved.
std::vector<mesh::TriangleSurface> bones_of(const Jaw& jaw) {
  std::vector<mesh::TriangleSurface> bones;
  for (const BoneSurface& bone : jaw.surfaces)
    bones.push_back(bone.surface);
  return bones;
}

void set_landmarks(const Drawings& drawings, FaceAnatomy& face) {
  for (const DrawnLandmark& landmark : drawings.landmarks) {
    // The outer node of a drawn point has the point's number (make_layered_shell, limit_mesh).
    face.landmarks.push_back({landmark.name, landmark.meaning,
                              drawings.skin.index.at(landmark.point), landmark.in_paper});
  }
  for (const auto& [a, b] : drawings.pairs)
    face.pairs.push_back({a, b});
}

/// Jaw and bones where the drawing's shape has them, then at the depths below the `outer` surface that are asked for: what moves
/// everything below the skin.
PointMap place_bones(const Drawings& drawings, const std::filesystem::path& folder,
                     const RadialWarp& warp, const std::vector<Vec3>& outer,
                     const MeasureValues& depths, FaceAnatomy& face) {
  Problems problems;
  std::vector<std::filesystem::path> files = face.files;
  face.jaw = make_builtin_jaw(folder, warp, files, problems);
  problems.throw_if_any<DataError>();
  PointMap below = warp;
  if (!depths.empty()) {
    const std::vector<MeasuredDepth> measured =
        measure_depths(drawings.depths, *face.jaw, smooth_surface(drawings.skin, outer));
    below = [warp, deeper = depth_warp(measured, depths, *face.jaw)](const Vec3& x) {
      return deeper(warp(x));
    };
    files = face.files;
    face.jaw = make_builtin_jaw(folder, below, files, problems);
  }
  face.files = std::move(files);
  return below;
}

/// Muscles and tension lines between the surfaces of the tissue.
void place_fibres(const Drawings& drawings, const BuiltinTissue& tissue, FaceAnatomy& face) {
  const SkinSites sites(drawings.skin);
  const auto at_sites = [&](const std::vector<Vec3>& control_points) {
    return mesh::weighted(sites.refined().limit, control_points);
  };
  const std::vector<Vec3> outer = at_sites(tissue.outer_control);
  Problems problems;
  face.muscle_paths =
      place_muscles(drawings, sites, outer, at_sites(tissue.inner_control), problems);
  const std::vector<mesh::LinePiece> pieces = place_lines(drawings, sites, outer, problems);
  problems.throw_if_any<DataError>();
  const mesh::LineField lines = tension_lines(sites, outer, pieces);
  (void)set_skin_axes(face, line_directions(face.mesh, sites, lines));
}

}  // namespace

FaceAnatomy make_builtin_face(const std::string& options, const std::filesystem::path& folder) {
  const Drawings drawings = read_drawings(folder);
  const std::vector<FaceMeasure>& measures = drawings.measures.measures;
  const BuiltinOptions chosen = parse_builtin_options(options, measures, drawings.depths);
  const MeasureValues wanted = complete_values(measures, chosen.female, chosen.given);
  const RadialWarp warp = shape_warp(drawings, wanted);
  FaceAnatomy face;
  face.source = options.empty() ? "builtin" : "builtin:" + options;
  face.files = drawings.files;
  const std::vector<Vec3> outer = warped(warp, drawings.skin.points);
  const PointMap below = place_bones(drawings, folder, warp, outer, chosen.depths, face);
  BuiltinTissue tissue =
      make_tissue(drawings.skin, outer, warped(below, drawings.inner),
                  skin_thickness(drawings.skin, drawings.skin_regions, chosen.female),
                  bones_of(*face.jaw), gap_to_bone, chosen.size);
  set_supports(drawings, tissue);
  face.eyes = place_eyes(drawings, tissue);
  face.mesh = tissue.mesh;
  face.lengths = lengths_of(drawings, wanted, chosen.depths, face);
  set_landmarks(drawings, face);
  place_fibres(drawings, tissue, face);
  constexpr double nowhere = 1e9;  // the skull is given
  mark_contact_regions(face, nowhere);
  return face;
}

}  // namespace facies::anatomy
