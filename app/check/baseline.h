// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/check/state_sequence.h"
#include "app/results/json.h"
#include "render/frame_options.h"
#include "render/image/png_file.h"
#include "render/renderer_fingerprint.h"

namespace hydroscope {

/// What a sequence looked like when somebody approved of it: a folder with
/// baseline.json, VIEW/00001.json for each frame, and VIEW/00001.png for some of them.
struct Baseline {
  FrameOptions options;  ///< how frames are drawn, as far as baseline.json keeps it
  RendererFingerprint fingerprint;
  std::vector<StateStamp> states;
  std::vector<int> pictures;  ///< frames that have a picture, from 1, rising

  bool has_picture(int frame) const;
};

/// Frames spread evenly over the sequence, first and last among them.
std::vector<int> pick_pictures(int frames, int most);

bool has_baseline(const std::filesystem::path& folder);

/// These throw InputError when something is missing or damaged.
Baseline read_baseline(const std::filesystem::path& folder);
Json read_baseline_sidecar(const std::filesystem::path& folder, const std::string& view, int frame);
PngPicture read_baseline_picture(const std::filesystem::path& folder, const std::string& view, int frame);

/// VIEW/00001 without ending.
std::filesystem::path make_baseline_name(const std::filesystem::path& folder, const std::string& view,
                                         int frame);

/// Writes baseline.json, and removes frames that it does not know. Throws EnvironmentError.
void write_baseline(const Baseline& baseline, const std::filesystem::path& folder);

}  // namespace hydroscope
