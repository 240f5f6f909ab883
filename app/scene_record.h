// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/results/run_writer.h"
#include "solver/scene/scene_source.h"

namespace hydroscope {

/// What a run of this scene keeps beside its results. Looks at the health of tool meshes: warnings go to
/// stderr, errors throw InputError.
RunRecord make_scene_record(const Scene& scene, const std::vector<SceneOverride>& overrides, int threads);

}  // namespace hydroscope
