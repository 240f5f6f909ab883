// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "solver/scene/scene.h"
#include "solver/session/mesh_facts.h"

namespace hydroscope {

/// The scene with everything that `accuracy` stands for chosen by the rules of docs/accuracy.md; what and why
/// is in `choices`. A scene without `accuracy`, or one that has been chosen for, comes back as it is.
///
/// The user's word counts (`Scene::given`): what is given stays, but a mesh that is too coarse is made finer.
/// Section and extent become the smallest part that stands for the whole. Reads the meshes of tools.
/// Throws InputError.
Scene choose_for_accuracy(const Scene& scene);

/// The same with what is known of the tools' meshes.
Scene choose_for_accuracy(const Scene& scene, const std::map<std::string, MeshFacts>& facts);

/// The cheap scene beside a chosen one: elements and increments twice as large, fewer thickness points, twice
/// the tolerance, nothing to be kept on the way.
Scene make_companion(const Scene& chosen);

/// A line a choice.
std::string describe_choices(const Scene& scene);

}  // namespace hydroscope
