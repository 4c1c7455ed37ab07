#include "cases/program/sweep/child.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <boost/process/args.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/io.hpp>
#include <csignal>
#include <cstdlib>
#include <system_error>

namespace furnas {
namespace {

namespace bp = boost::process;

/// Called in the new process, before the program starts.
void part_from(pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(EXIT_FAILURE);  // the parent has ended before the signal was set
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const std::filesystem::path& log)
    : process_("/proc/self/exe", bp::args(arguments),
               bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.string(),
               bp::extend::on_exec_setup([parent = ::getpid()](auto&) { part_from(parent); })) {}

std::optional<int> Child::ended() {
  if (process_.running()) return {};
  const int status = process_.native_exit_code();
  if (WIFSIGNALED(status)) return -WTERMSIG(status);
  return WEXITSTATUS(status);
}

void Child::stop() { ::kill(process_.id(), SIGTERM); }

void Child::kill() {
  std::error_code ended;
  process_.terminate(ended);
}

}  // namespace furnas
