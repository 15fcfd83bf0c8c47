// SPDX-License-Identifier: BSD-3-Clause
#include "view/live_view.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <thread>

#include "command_line/message.h"
#include "files/interrupt.h"

namespace boxplus::app {

namespace {

constexpr auto kPause = std::chrono::milliseconds(50);

}  // namespace

LiveView::LiveView(GraphFile& file, const std::string& path, const ServingArguments& arguments,
                   viewer::Drawn drawn)
    : workspace_(nullptr), server_(workspace_, arguments.server) {
  workspace_.show(std::make_unique<viewer::GraphSubject>(file.graph, shown_name(path), &file, drawn));
  workspace_.hold();
  print_message(fmt::format("view it at {}", server_.url()));
  if (arguments.opens_browser) open_browser(server_.url(), {});
}

void LiveView::wait_for_page() const {
  while (!workspace_.has_readers() && !Interrupt::raised()) std::this_thread::sleep_for(kPause);
}

void LiveView::serve(const Report& report, int code) {
  workspace_.watch_end(viewer::outcome_of(report));
  serve_graph(code);
}

void LiveView::serve(int code) {
  show();
  serve_graph(code);
}

void LiveView::serve_graph(int code) {
  if (Interrupt::raised()) return;
  workspace_.hand_over();
  print_message(fmt::format("the viewer stays at {}; Ctrl-C ends it", server_.url()));
  while (!Interrupt::raised()) std::this_thread::sleep_for(kPause);
  end_soon(code);
}

}  // namespace boxplus::app
