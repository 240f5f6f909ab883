// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/quad_blocks.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

using Quad = std::array<int, 4>;
/// Row and column of a node in the grid that its quads form; neighbours differ by one.
using Place = std::array<int, 2>;

/// Walks over shared edges. A grid that closes on itself, or is none, leaves nodes whose quads
/// disagree: such quads are no unit squares afterwards and join no block.
class Grid {
 public:
  explicit Grid(const std::vector<Quad>& quads) : quads_(quads) {
    int nodes = 0;
    for (const Quad& quad : quads) nodes = std::max(nodes, 1 + *std::max_element(quad.begin(), quad.end()));
    places_.resize(at(nodes));
    for (int q = 0; q < static_cast<int>(quads.size()); ++q)
      for (std::size_t k = 0; k < 4; ++k) owners_[key(quads[at(q)], k)].push_back(q);
    std::vector<char> is_done(quads.size(), 0);
    for (int q = 0; q < static_cast<int>(quads.size()); ++q)
      if (is_done[at(q)] == 0) walk(q, is_done);
  }

  /// The place of a quad's lowest corner, where it is a unit square.
  std::optional<Place> find_square(int q) const {
    Place least = *places_[at(quads_[at(q)][0])], most = least;
    for (const int node : quads_[at(q)])
      for (std::size_t c = 0; c < 2; ++c) {
        least[c] = std::min(least[c], (*places_[at(node)])[c]);
        most[c] = std::max(most[c], (*places_[at(node)])[c]);
      }
    if (most[0] - least[0] != 1 || most[1] - least[1] != 1) return std::nullopt;
    return least;
  }
  const Place& place(int node) const { return *places_[at(node)]; }

 private:
  static std::pair<int, int> key(const Quad& quad, std::size_t k) {
    return std::minmax({quad[k], quad[(k + 1) % 4]});
  }

  void walk(int start, std::vector<char>& is_done) {
    constexpr std::array<Place, 4> kSquare{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t k = 0; k < 4; ++k)
      if (auto& place = places_[at(quads_[at(start)][k])]; !place) place = kSquare[k];
    std::vector<int> open{start};
    is_done[at(start)] = 1;
    for (std::size_t next = 0; next < open.size(); ++next)
      for (std::size_t k = 0; k < 4; ++k)
        for (const int other : owners_.at(key(quads_[at(open[next])], k)))
          if (is_done[at(other)] == 0) {
            is_done[at(other)] = 1;
            continue_into(quads_[at(other)]);
            open.push_back(other);
          }
  }

  /// Two neighbouring corners of the quad have places; the others follow by turning to the left.
  void continue_into(const Quad& quad) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& a = places_[at(quad[k])];
      const auto& b = places_[at(quad[(k + 1) % 4])];
      if (!a || !b) continue;
      const Place left{-((*b)[1] - (*a)[1]), (*b)[0] - (*a)[0]};
      const auto set = [&](std::size_t corner, const Place& from) {
        auto& place = places_[at(quad[corner % 4])];
        if (!place) place = Place{from[0] + left[0], from[1] + left[1]};
      };
      const Place from_a = *a, from_b = *b;
      set(k + 2, from_b);
      set(k + 3, from_a);
      return;
    }
  }

  const std::vector<Quad>& quads_;
  std::vector<std::optional<Place>> places_;
  std::map<std::pair<int, int>, std::vector<int>> owners_;
};

int half(int number) { return number >= 0 ? number / 2 : -((1 - number) / 2); }

}  // namespace

QuadBlocks find_quad_blocks(const std::vector<std::array<int, 4>>& quads) {
  const Grid grid(quads);
  std::map<Place, std::vector<int>> groups;
  QuadBlocks found;
  for (int q = 0; q < static_cast<int>(quads.size()); ++q) {
    const auto place = grid.find_square(q);
    if (place)
      groups[{half((*place)[0]), half((*place)[1])}].push_back(q);
    else
      found.singles.push_back(q);
  }
  for (const auto& [place, members] : groups) {
    // The corner of each quad that is a corner of the block: both its coordinates are even.
    std::vector<std::pair<Place, int>> corners;
    for (const int q : members)
      for (const int node : quads[at(q)])
        if (const Place& p = grid.place(node); p[0] % 2 == 0 && p[1] % 2 == 0) corners.emplace_back(p, node);
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (members.size() != 4 || corners.size() != 4) {
      found.singles.insert(found.singles.end(), members.begin(), members.end());
      continue;
    }
    // Sorted by column, then row: (0,0), (0,2), (2,0), (2,2); quads turn to the left.
    found.blocks.push_back({{corners[0].second, corners[2].second, corners[3].second, corners[1].second},
                            {members[0], members[1], members[2], members[3]}});
  }
  return found;
}

}  // namespace hydroscope
