// SPDX-License-Identifier: BSD-3-Clause
// The HTTP server of the viewer: the page, its commands and its stream.
#pragma once

#include <memory>
#include <string>

#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {

struct ServerOptions {
  std::string host = "127.0.0.1";
  int port = 0;  ///< 0: kUsualPort, or any free port if it is taken
  static constexpr int kUsualPort = 8743;
};

/// Serves one workspace until it is destroyed. The requests and their limits are listed in PROTOCOL.md.
class Server {
 public:
  /// Binds the port and starts to serve on threads of its own. Throws Error if the address cannot be bound.
  Server(Workspace& workspace, const ServerOptions& options);
  /// Closes all streams. Returns within a second.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::string url() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace boxplus::viewer
