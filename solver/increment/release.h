// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/scratch.h"

namespace hydroscope {

/// Takes a contact point off its tool and notes why.
void set_free(ContactPoint& point, const Release& release);

/// Smoothed contact pressure of a tool's patch at a node [MPa]: the node with
/// half of each neighbour in contact, over the same areas (mechanics 9.4).
double calc_smoothed_pressure(const Model& model, const std::vector<ContactPoint>& contacts,
                              const std::vector<double>& area, int node);

/// A node that is to let go of a tool.
struct NodeRelease {
  std::size_t node = 0;
  Release why;
};

/// Nodes that let go of tool `tool` by the full rule of mechanics 9.4: by clear tension, past the tool's
/// edge, and where they are many their neighbours in contact as far as there is a quarter of that tension. A
/// backed wall lets go together (V9); were a part of it left hanging, it would bend the rest.
std::vector<NodeRelease> find_releases(const Model& model, const Loads& loads, std::size_t tool,
                                       const Trial& trial);

/// The naive rules (mechanics 9.2), applied to an increment that is done: contacts whose normal force pulls,
/// with the fluid subtracted or not. True when any let go.
bool release_by_sign(const Model& model, const Loads& loads, const std::vector<NodeBasis>& bases,
                     Trial& trial);

}  // namespace hydroscope
