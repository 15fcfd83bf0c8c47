// SPDX-License-Identifier: BSD-3-Clause
// The server of builds without cpp-httplib.
#include "boxplus/base/error.h"
#include "viewer/server/server.h"

namespace boxplus::viewer {

class Server::Implementation {};

Server::Server(Workspace& /*workspace*/, const ServerOptions& /*options*/) {
  throw Error("this build has no server for the viewer");
}

Server::~Server() = default;

std::string Server::url() const {
  return {};
}

}  // namespace boxplus::viewer
