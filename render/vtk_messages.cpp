// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/vtk_messages.h"

#include <vtkNew.h>            // VTK::CommonCore
#include <vtkObjectFactory.h>  // VTK::CommonCore
#include <vtkOutputWindow.h>   // VTK::CommonCore
// The public vtkSMPTools.h of 9.1 is no valid C++20.
#include <SMP/Common/vtkSMPToolsAPI.h>  // VTK::CommonCore

#include <mutex>

namespace hydroscope {
namespace {

// A context belongs to one thread, so what it complains about arrives there.
thread_local std::string t_messages;

class MessageCollector : public vtkOutputWindow {
 public:
  static MessageCollector* New();
  vtkTypeMacro(MessageCollector, vtkOutputWindow);

  void DisplayText(const char* text) override {
    // One broken shader repeats itself in every draw: the first lines say enough.
    if (text != nullptr && t_messages.size() < 4000) t_messages += text;
  }
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(MessageCollector);

}  // namespace

void set_up_vtk() {
  static std::once_flag once;
  std::call_once(once, [] {
    const vtkNew<MessageCollector> collector;
    vtkOutputWindow::SetInstance(collector);
    // Drawing has the threads that it was given and no others.
    vtk::detail::smp::vtkSMPToolsAPI::GetInstance().SetBackend("Sequential");
  });
}

std::string take_vtk_messages() {
  std::string taken;
  taken.swap(t_messages);
  return taken;
}

}  // namespace hydroscope
