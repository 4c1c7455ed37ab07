#pragma once

#include <boost/process/child.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace furnas {

/// This program as a separate process. Signals from the terminal do not reach it, and it gets a request to
/// save and stop when its parent dies.
class Child {
 public:
  /// Starts `furnas ARGUMENTS`, whose output goes to the file `log`.
  Child(const std::vector<std::string>& arguments, const std::filesystem::path& log);
  Child(Child&&) = default;
  Child& operator=(Child&&) = default;

  /// The exit code once the process has ended; if a signal ended it, minus the number of the signal.
  std::optional<int> ended();

  /// Requests it to save and stop.
  void stop();

  /// Ends it at once, without saving, and waits for its end.
  void kill();

 private:
  boost::process::child process_;
};

}  // namespace furnas
