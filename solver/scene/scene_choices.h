// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "solver/scene/scene.h"
#include "solver/scene/scene_checks.h"

namespace hydroscope {

/// Settings that follow from others where the user has left them open.
///
/// A forward step is only as good as its linearisation: without an iterating corrector the limits of r_min
/// are drawn tight, the onset of yielding is sharp, and increments end where a point yields, a contact lets go or begins to slip.
void choose_explicit_limits(const GivenKeys& given, Scene& scene);

/// Keys that `accuracy` takes as the user's word. Who asks for it on the command line asks for new settings
/// of a scene: then only other keys from there count, not those of the file.
std::set<std::string> list_user_words(const GivenKeys& given);

}  // namespace hydroscope
