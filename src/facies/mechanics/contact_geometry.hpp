// SPDX-License-Identifier: Apache-2.0
// What the two halves of Contact share: forces (contact.cpp) and ways of points in a step (contact_way.cpp).
#pragma once

#include "facies/base/parallel.hpp"
#include "facies/mechanics/contact.hpp"

namespace facies::mechanics {

/// A trial state with anything beyond this has gone astray [mm].
inline constexpr double farthest = 1e9;

/// Points and surface at a state, in the frame of the surface where that is rigid: there it does not move.
struct Contact::Geometry {
  std::vector<Vec3> points;
  std::vector<Vec3> vertices;
  std::shared_ptr<const mesh::NearestTriangles> nearest;  // of the triangles alone
};

/// A state, and what is near in it.
struct Contact::Scene {
  Geometry geometry;
  std::vector<Pair> near;  // nearer than d_hat
};

/// From there to another state, in the same frame.
struct Contact::Ways {
  std::vector<Vec3> points;
  std::vector<Vec3> vertices;
  Vec3 least, most;  // corners of the box that holds all ways of vertices
};

/// Calls work(p) for every point, on several threads.
template <class Work>
void Contact::for_each_point(const Work& work) const {
  parallel_for(points_.size(), settings_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      work(p);
  });
}

}  // namespace facies::mechanics
