// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/session/steered_run.h"

namespace hydroscope {

/// Full keys that may be changed while a run goes on: those of what lies ahead, none of mesh, material, shell
/// or the shape of tools.
std::vector<std::string> settable_keys(const Scene& scene);

/// What a change starts from.
struct ChangeContext {
  const RunSetup& setup;
  const std::string& source;  ///< text of the scene
  const State& state;
};

struct SceneChange {
  std::shared_ptr<const RunSetup> setup;
  bool has_turned = false;  ///< a path turns at the present time
};

/// The setup with `key` set to `value`, read and checked like a scene. Of a path what lies behind the present
/// time stays; it must go on from the present value, or begin later. Throws InputError.
SceneChange change_ahead(const ChangeContext& context, const std::string& key, const std::string& value);

}  // namespace hydroscope
