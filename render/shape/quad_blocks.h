// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace hydroscope {

/// A mesh of quads with four of them taken together wherever they form a square of two by two.
struct QuadBlocks {
  struct Block {
    std::array<int, 4> corners;  ///< nodes, in the order of the quads
    std::array<int, 4> quads;    ///< what it is made of
  };
  std::vector<Block> blocks;
  std::vector<int> singles;  ///< quads that belong to no block
};

QuadBlocks find_quad_blocks(const std::vector<std::array<int, 4>>& quads);

}  // namespace hydroscope
