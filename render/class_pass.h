// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "render/image/colour_map.h"
#include "render/image/image.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// The contact map drawn so that it can be read back: flat colours, no text, no smooth
/// edges, no tools, no mirror images. Beside it the same wall with each node's quarters in a
/// colour that is the node's number.
struct ClassPicture {
  Image classes;
  Image nodes;
};

/// What the pictures say about the nodes, against what the solver says.
struct ClassAgreement {
  int nodes = 0;
  int unseen = 0;                             ///< nodes that no picture shows: hidden behind other walls
  std::array<int, kContactClasses> drawn{};   ///< nodes seen, by the class they are drawn in
  std::array<int, kContactClasses> solved{};  ///< the same nodes by the solver's class
  std::vector<int> wrong;    ///< nodes whose pixels mostly show another class than the solver's
  double stray_share = 0.0;  ///< of the sheet's pixels: those whose class is not their node's

  bool is_blank() const { return nodes > 0 && unseen == nodes; }
};

/// Draws and reads class pictures. Belongs to the thread that makes it.
class ClassPass {
 public:
  explicit ClassPass(int rasteriser_threads = 1);
  ~ClassPass();
  ClassPass(const ClassPass&) = delete;
  ClassPass& operator=(const ClassPass&) = delete;

  /// As many pictures, from straight above nodes not seen yet, as show every node; at most kMostPictures.
  std::vector<ClassPicture> draw(const Snapshot& snapshot);

  static constexpr int kMostPictures = 12;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Counts pixels by node and class, and compares with the snapshot's classes.
ClassAgreement read_class_pictures(const std::vector<ClassPicture>& pictures, const Snapshot& solved);

}  // namespace hydroscope
