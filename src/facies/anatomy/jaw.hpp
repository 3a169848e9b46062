// SPDX-License-Identifier: Apache-2.0
// The jaw of a face as plain data: a bone that moves, the bones that do not, what leads it and what pulls it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "facies/anatomy/side.hpp"
#include "facies/base/index.hpp"
#include "facies/math/swept_curve.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::anatomy {

/// A bone, in the place that its surface file has it.
struct Bone {
  std::string name;  ///< "jaw"
  std::string meaning;
  bool moves = false;                  ///< false: fixed in space, and nothing below counts
  double mass = 0.0;                   ///< [kg]
  Vec3 centre = Vec3::Zero();          ///< of mass [mm]
  Mat3 inertia = Mat3::Zero();         ///< about the centre, in the axes of the face [kg mm^2]
  double translational_damping = 0.0;  ///< force by velocity [kg/s]
  double rotational_damping = 0.0;     ///< moment by angular velocity [kg mm^2/s]
};

/// Where the jaw has gone from the place of its file: x = centre + u + R (X - centre).
struct JawPose {
  Vec3 u = Vec3::Zero();  ///< [mm]
  Mat3 R = Mat3::Identity();
};

/// A point of a bone.
struct BonePoint {
  Index bone = -1;
  Vec3 X = Vec3::Zero();  ///< in the place of the bone's file [mm]
};

/// A point of a bone that has a name: an incisor, a condyle.
struct JawPoint {
  std::string name;  ///< "lower_incisor"
  std::string meaning;
  BonePoint at;
};

/// A point of the jaw that stays on a surface.
struct JawGuide {
  std::string name;  ///< "TMJ_left"
  Index point = -1;  ///< of Jaw::points
  SweptCurve curve;
  std::string where;  ///< of its entry in a file, for messages
};

/// A point of the jaw that does not pass a plane.
struct JawStop {
  std::string name;  ///< "bite_left"
  std::string meaning;
  Index point = -1;             ///< of Jaw::points
  bool enabled = true;          ///< false: known, but not to be used
  Vec3 plane = Vec3::Zero();    ///< a point of the plane [mm]
  Vec3 normal = Vec3::UnitZ();  ///< unit, towards the side where the point may be
  std::string where;            ///< of its entry in a file, for messages
};

/// A muscle between two points. Its law: mechanics::HillParameters.
struct JawMuscle {
  std::string name;  ///< "lat"
  std::string meaning;
  Side side = Side::middle;
  BonePoint origin, insertion;
  double max_force = 0.0;         ///< [mN]
  double optimal_length = 0.0;    ///< [mm]
  double max_length = 0.0;        ///< [mm]
  double tendon_ratio = 0.0;      ///< part of the optimal length
  double passive_fraction = 0.0;  ///< part of max_force
  double damping = 0.0;           ///< [mN s/mm]
};

/// A named group of muscles that are driven together: "bi_open".
struct Exciter {
  std::string name;
  std::string meaning;
  std::vector<Index> muscles;  ///< of Jaw::muscles, in their order
};

/// What a surface is for: the border of a bone, an open sheet of one, or a cast of plaster, which is no part of the body.
enum class SurfaceKind { solid, shell, cast };

/// The surface of a bone or of a part of it.
struct BoneSurface {
  std::string name;  ///< "lower_teeth"
  std::string meaning;
  Index bone = -1;
  SurfaceKind kind = SurfaceKind::solid;
  std::filesystem::path file;
  double scale = 1.0;    ///< from the file's unit to mm
  bool closed = false;   ///< it encloses the bone, without a border
  bool presses = false;  ///< with its own vertices on the tissue, not only the tissue's nodes on it
  mesh::TriangleSurface surface;  ///< as read (read_bone_surface); empty for a cast
};

/// The crowns of teeth, where they are part of the surface of a bone.
struct Crowns {
  Index surface = -1;           ///< of Jaw::surfaces
  Vec3 normal = Vec3::UnitZ();  ///< unit, towards the teeth
  double offset =
      0.0;  ///< teeth are what has normal . X >= offset and X.x <= back, in the place of the file [mm]
  double back = 0.0;  ///< [mm]

  [[nodiscard]] bool holds(const Vec3& X) const { return normal.dot(X) >= offset && X.x() <= back; }
};

struct Jaw {
  std::vector<Bone> bones;
  Index mandible = -1;  ///< the bone that moves
  JawPose start;        ///< where a run begins; it need not satisfy the guides and stops
  JawPose intercuspal;  ///< teeth in contact
  std::vector<JawPoint> points;
  std::vector<JawGuide> guides;
  std::vector<JawStop> stops;
  std::vector<JawMuscle> muscles;
  std::vector<Exciter> exciters;
  std::vector<BoneSurface> surfaces;
  std::vector<Crowns> crowns;
  std::string attached_nodes = "mandibular";  ///< node set of the mesh that is tied to the jaw
};

/// Where a point is when the jaw is in this pose [mm].
[[nodiscard]] Vec3 place_of(const Jaw& jaw, const JawPose& pose, const BonePoint& point);

/// The entry of this name in a list of named things; nullptr where there is none.
template <class T>
[[nodiscard]] const T* find_named(const std::vector<T>& list, std::string_view name) {
  for (const T& entry : list) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

/// Distance of two named points in this pose [mm]: "lower_incisor", "upper_incisor". Throws BugError where one is missing.
[[nodiscard]] double distance(const Jaw& jaw, const JawPose& pose, std::string_view a,
                              std::string_view b);

}  // namespace facies::anatomy
