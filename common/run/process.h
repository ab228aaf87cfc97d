#pragma once
// What every main does: signals become a stop_token, exceptions become one line and an exit status.
#include <functional>
#include <stop_token>
#include <string>

namespace ronda {

/// Runs `body` with SIGINT and SIGTERM blocked (threads that it starts inherit that) and turned
/// into `stop`: the first requests the stop, 130 or 143 is then the exit status of a body that
/// returns 0. An Error is printed as `name: message` and gives its exit status; any other exception
/// gives 1. Call it first thing in main.
int RunProcess(const std::string& name, const std::function<int(std::stop_token stop)>& body);

/// This process gets SIGTERM when its parent dies; if the parent is gone already, at once. Linux
/// only.
void EndWithParent();

}  // namespace ronda
