// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/results/json.h"
#include "app/server/contact_counts.h"
#include "app/server/frame_service.h"
#include "app/server/run_files.h"
#include "app/workstation/workstation.h"

namespace hydroscope {

// The values that the server gives out, as JSON. Keys carry units; what is not known is null.

/// Without line breaks and indents, as a line of an event stream has to be.
std::string to_line(const Json& json);

/// What a viewer knows of itself and of others.
struct ViewerFacts {
  int viewers = 0;
  std::string steering;  ///< empty: nobody
  std::string self;
};
Json make_status_json(const WorkstationStatus& status, const ViewerFacts& viewers,
                      const FrameFigures& frames);
Json make_reply_json(const CommandReply& reply);
Json make_timeline_json(const std::vector<KeptState>& kept);
Json make_history_json(const std::vector<IncrementReport>& rows, const std::vector<std::string>& quantities);
Json make_warning_json(const Warning& warning);
Json make_warnings_json(const std::vector<Warning>& warnings);
Json make_contact_json(const ContactCounts& counts);
Json make_files_json(const std::vector<RunFile>& files);
Json make_error_json(const std::string& text);
Json make_vector_json(const Vec3& vector);

/// What never changes.
Json make_model_json(const Snapshot& first, const std::vector<std::string>& quantities,
                     const std::vector<std::string>& settable);

}  // namespace hydroscope
