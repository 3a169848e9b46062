// SPDX-License-Identifier: Apache-2.0
// A face as plain data: what every geometry source produces and every model is built from.
//
// Axes of every face: -x anterior, +y the subject's right, +z up; lengths in mm.
// Names of sets in `mesh` that models rely on (a set that a face does not have is empty):
//   elements  skin, hypodermis_mid, hypodermis_inner      the layers, outermost first; together all elements
//   faces     outer, inner                                the skin's surface; the surface towards the bone
//   nodes     outer, inner                                the nodes of those faces
//   nodes     held_in_tension                             stay at their places while the tension is put in
//   nodes     rim, zygomatic, nose, orbit                 fixed from the release on
//   nodes     mandibular                                  tied to the mandible from the release on
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facies/anatomy/jaw.hpp"
#include "facies/anatomy/side.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::anatomy {

/// Layers, outermost first.
inline const std::vector<std::string>& layer_names() {
  static const std::vector<std::string> names = {"skin", "hypodermis_mid", "hypodermis_inner"};
  return names;
}

/// A fibre: a polyline of points [mm] in the mesh's reference configuration, closed or open.
struct FibrePath {
  Side side = Side::middle;
  bool closed = false;
  std::vector<Vec3> points;
  /// Unit, out of the layer of tissue there, one per point: the short axis of a band. Empty where the muscle is no band.
  std::vector<Vec3> normals = {};
};

/// A muscle as drawn: its paths on both sides. "ZYG" drives all of it, "ZYG_L" and "ZYG_R" one side.
struct MusclePaths {
  std::string name;     ///< "ZYG"
  std::string meaning;  ///< "zygomaticus"
  std::vector<FibrePath> paths;
  double width = 0.0;  ///< of the band along each path, in the plane of the skin [mm]; 0: no band
  double thickness = 0.0;  ///< of that band, along the paths' normals [mm]

  /// Whether its elements are those of bands along its paths, not those within a radius.
  [[nodiscard]] bool is_band() const { return width > 0.0; }
};

/// A muscle of one side as a set of elements with fibre directions; made from paths by select_muscles.
struct Muscle {
  std::string name;   ///< "ZYG_L", or "OOP" for a ring
  std::string group;  ///< "ZYG"
  Side side = Side::middle;
  std::vector<Index> elements;   ///< sorted
  std::vector<Vec3> directions;  ///< unit, one per element
  std::vector<double> shares;    ///< of each element's volume that is muscle: above 0, at most 1
};

/// A named point of the face that is followed through a run.
struct Landmark {
  std::string name;     ///< "RMC"
  std::string meaning;  ///< "right mouth corner"
  Index node = -1;
  bool in_paper = false;  ///< one of the landmarks of the paper's Figure 4
};

/// A distance that is followed through a run.
struct LandmarkPair {
  std::string a, b;
};

/// An eyeball, which lids lie on. It is looked at; nothing moves it, and what lies on it is fixed.
struct Eye {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;  ///< [mm]
};

/// A length that one may ask for when a face is made.
struct FaceLength {
  std::string key;  ///< "mouth_width"
  std::string meaning;
  std::optional<double> wanted;          ///< [mm]; nothing where it follows from the others
  double found = 0.0;                    ///< that of the face [mm]
  double smallest = 0.0, largest = 0.0;  ///< what may be asked for [mm]
};

struct FaceAnatomy {
  std::string source;                        ///< how it was made: "artisynth:/path", "patch"
  std::vector<std::filesystem::path> files;  ///< everything that was read for it
  mesh::Mesh mesh;
  std::vector<Mat3>
      axes;  ///< [n_elements] columns a1 (skin line), a2 (outward normal), a3; identity outside the skin
  std::vector<MusclePaths> muscle_paths;
  std::vector<Landmark> landmarks;
  std::vector<LandmarkPair> pairs;
  std::optional<Jaw> jaw;           ///< nothing for a face without one
  std::vector<Eye> eyes;            ///< nothing where what lies behind the lids is not known
  std::vector<FaceLength> lengths;  ///< nothing for a face that is not made from measures
  std::vector<std::string>
      notes;  ///< what a reader did that a user should know ("6024 left-handed hexahedra turned")
  bool is_reference_face =
      false;  ///< the paper's own face: its numbers may be compared with the paper's
};

/// Takes fibres out of the face's muscles: "LAO.1" is the first path of LAO on each side (or in the middle). Answers the
/// names of all fibres that the face has, before anything is taken out; names that are not among them change nothing.
std::vector<std::string> leave_out_fibres(FaceAnatomy& face,
                                          const std::vector<std::string>& fibres);

/// How far muscles reach beyond their fibres [mm].
struct MuscleReach {
  double radius = 0.0;  ///< around a fibre without a width
  double margin = 0.0;  ///< all around a band
};

/// Muscles as elements, sorted. An element belongs to
/// - a muscle without a width if its centroid lies closer than the radius to one of its paths, both measured in the
///   reference configuration divided by `scale` (paper's TSF: the stress-free size), with all of its volume, on the side of the nearest path;
/// - a band if a twentieth of it lies, in the reference configuration, in the bands along the paths of a side, each as wide and thick as the
///   muscle and the margin all around it, not beyond the path's ends. It belongs with the share that does, told by 64 parts.
///   Elements of the skin, and those that share no face with another one of the muscle, are left out.
/// Order: that of muscle_paths, left before right. Throws DataError for a muscle that gets no element.
[[nodiscard]] std::vector<Muscle> select_muscles(const FaceAnatomy& face, const MuscleReach& reach,
                                                 double scale);

}  // namespace facies::anatomy
