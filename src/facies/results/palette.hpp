// SPDX-License-Identifier: Apache-2.0
// The colours of a face in pictures: of surfaces in the light, and of what a cut goes through.
#pragma once

#include "facies/results/colour.hpp"

namespace facies::results::palette {

inline constexpr Colour skin{0.875F, 0.805F, 0.750F};  ///< neutral, light, a little warm
inline constexpr Colour inside{0.66F, 0.47F, 0.43F};   ///< the inner side of the tissue
inline constexpr Colour rim{0.80F, 0.68F, 0.61F};      ///< where the mesh ends
inline constexpr Colour hollow{0.36F, 0.29F, 0.27F};   ///< what closes eyes, nostrils and mouth
inline constexpr Colour bone{0.86F, 0.80F, 0.66F};
inline constexpr Colour teeth{0.96F, 0.95F, 0.90F};
inline constexpr Colour sclera{0.93F, 0.91F, 0.88F};
inline constexpr Colour iris{0.38F, 0.30F, 0.23F};
inline constexpr Colour pupil{0.07F, 0.06F, 0.06F};

inline constexpr std::array<Colour, 4> cut_layers{
    {{0.74F, 0.38F, 0.30F}, {0.97F, 0.83F, 0.47F}, {0.92F, 0.61F, 0.36F}, {0.62F, 0.55F, 0.66F}}};
inline constexpr Colour cut_bone{0.66F, 0.60F, 0.48F};

/// Bones beside each other in one picture; they repeat after the last.
inline constexpr std::array<Colour, 4> bones{
    {{0.79F, 0.69F, 0.53F}, {0.88F, 0.84F, 0.74F}, {0.66F, 0.60F, 0.55F}, {0.72F, 0.76F, 0.70F}}};
inline constexpr Colour skin_line{0.45F, 0.10F, 0.12F};

/// Muscles beside each other; they repeat after the last.
inline constexpr std::array<Colour, 20> muscles{
    {{0.80F, 0.15F, 0.20F}, {0.20F, 0.45F, 0.80F}, {0.95F, 0.72F, 0.10F}, {0.15F, 0.60F, 0.35F},
     {0.55F, 0.30F, 0.15F}, {0.50F, 0.15F, 0.60F}, {0.95F, 0.50F, 0.15F}, {0.10F, 0.62F, 0.66F},
     {0.92F, 0.55F, 0.52F}, {0.70F, 0.10F, 0.42F}, {0.50F, 0.72F, 0.20F}, {0.62F, 0.78F, 0.95F},
     {0.72F, 0.45F, 0.25F}, {0.10F, 0.20F, 0.50F}, {0.95F, 0.85F, 0.45F}, {0.75F, 0.62F, 0.90F},
     {0.88F, 0.38F, 0.62F}, {0.40F, 0.42F, 0.08F}, {0.35F, 0.75F, 0.60F}, {0.45F, 0.45F, 0.50F}}};

}  // namespace facies::results::palette
