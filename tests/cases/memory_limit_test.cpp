#include "cases/program/memory_limit.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// A made-up system with these files.
MemoryLimit limit_of(const std::vector<std::pair<std::string, std::string>>& files) {
  const TemporaryFolder root;
  for (const auto& [name, text] : files) {
    fs::create_directories((root / name).parent_path());
    write_file(root / name, text);
  }
  return memory_limit(root / "");
}

TEST(ReliableMemoryLimit, IsThatOfTheMachineAtMost) {
  const MemoryLimit machine = limit_of({});
  EXPECT_GT(machine.bytes, 1e8);
  EXPECT_EQ(machine.source, "this machine has");
  EXPECT_LE(memory_limit().bytes, machine.bytes);
}

TEST(ReliableMemoryLimit, KnowsControlGroups) {
  const std::pair<std::string, std::string> unified{"proc/self/cgroup", "0::/user/job\n"};
  EXPECT_EQ(limit_of({unified, {"sys/fs/cgroup/user/job/memory.max", "1000000\n"}}).bytes, 1e6);
  EXPECT_EQ(limit_of({unified, {"sys/fs/cgroup/user/memory.max", "2000000\n"}}).bytes, 2e6);
  EXPECT_EQ(limit_of({unified,
                      {"sys/fs/cgroup/user/job/memory.max", "max\n"},
                      {"sys/fs/cgroup/memory.max", "3000000\n"}})
                .bytes,
            3e6);
  EXPECT_EQ(limit_of({unified, {"sys/fs/cgroup/user/job/memory.max", "max\n"}}).source, "this machine has");
  const MemoryLimit old = limit_of({{"proc/self/cgroup", "5:cpu:/x\n4:memory:/job\n"},
                                    {"sys/fs/cgroup/memory/job/memory.limit_in_bytes", "4000000\n"}});
  EXPECT_EQ(old.bytes, 4e6);
  EXPECT_EQ(old.source, "its control group allows");
}

TEST(ReliableMemoryLimit, KnowsUlimit) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs more";
#endif
  struct rlimit before {};
  ::getrlimit(RLIMIT_DATA, &before);
  struct rlimit set = before;
  set.rlim_cur = 1'500'000'000;
  ::setrlimit(RLIMIT_DATA, &set);
  const MemoryLimit limit = limit_of({});
  ::setrlimit(RLIMIT_DATA, &before);
  EXPECT_EQ(limit.bytes, 1.5e9);
  EXPECT_EQ(limit.source, "ulimit allows");
}

}  // namespace
}  // namespace furnas
