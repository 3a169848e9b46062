// SPDX-License-Identifier: Apache-2.0
// How deep the bones of the built-in face lie below its skin, and how they move to lie at another depth
// (docs/theory/builtin-face.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facies/anatomy/builtin_jaw.hpp"
#include "facies/anatomy/builtin_measures.hpp"
#include "facies/anatomy/cage.hpp"

namespace facies::anatomy {

/// Which way a depth is measured, from the bone to the skin.
enum class DepthDirection {
  normal,   ///< along the outward normal of the bone
  forward,  ///< straight forward: at the lips
  down      ///< straight down: under the chin
};

/// A site of soft tissue depth. One that is not in the midline is on both halves.
struct DepthSite {
  std::string key;  ///< "depth_pogonion"
  std::string meaning;
  std::string drawing;  ///< of the bone: "mandible.json"
  std::vector<Index>
      points;  ///< of the drawing's right half: the site is where their mean meets the bone
  DepthDirection direction = DepthDirection::normal;
  double mean = 0.0;                     ///< published, of both sexes [mm]
  std::optional<double> men, women;      ///< published for white adults of normal build [mm]
  double smallest = 0.0, largest = 0.0;  ///< what a face may ask for [mm]
};

/// depths.csv of a folder. Adds everything that is wrong to `problems`.
[[nodiscard]] std::vector<DepthSite> read_depth_sites(const std::filesystem::path& folder,
                                                      Problems& problems);

/// The tissue at a site of a face, right half or midline.
struct MeasuredDepth {
  std::string key;
  Vec3 bone = Vec3::Zero();  ///< [mm]
  Vec3 way = Vec3::UnitX();  ///< unit, from the bone to the skin
  double depth = 0.0;        ///< [mm]
};

/// The depths of a face with this jaw and this skin, bone by bone in the order of the sites. A site without skin in front of it is left
/// out.
[[nodiscard]] std::vector<MeasuredDepth> measure_depths(const std::vector<DepthSite>& sites,
                                                        const Jaw& jaw,
                                                        const mesh::TriangleSurface& skin);

/// How everything below the skin moves so that the bone lies at the depths `wanted` [mm, by key]: the site goes along the way on
/// which it was measured, all other sites and the points of the jaw (condyles, teeth) stay, what is between follows smoothly.
/// Throws BugError for a key that was not measured.
[[nodiscard]] PointMap depth_warp(const std::vector<MeasuredDepth>& measured,
                                  const MeasureValues& wanted, const Jaw& jaw);

}  // namespace facies::anatomy
