// Files that are whole or absent, and what killed processes leave of them.
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/packing_series.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Another process, in the middle of writing a file.
class OtherWriter {
 public:
  explicit OtherWriter(const fs::path& target) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    process_ = fork();
    if (process_ == 0) {
      PendingFile file(target);
      file.write("half");
      [[maybe_unused]] const auto sent = write(ends[1], "x", 1);
      for (;;) pause();
    }
    char begun = 0;
    REQUIRE(read(ends[0], &begun, 1) == 1);
    close(ends[0]);
    close(ends[1]);
  }
  ~OtherWriter() { end(); }

  void end() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
};

}  // namespace

TEST_CASE("a file appears whole, and without commit not at all") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "before";
  {
    PendingFile file(folder / "a.txt");
    file.write("af");
    file.write("ter");
    CHECK(read_text_file(folder / "a.txt") == "before");
  }
  CHECK(read_text_file(folder / "a.txt") == "before");
  CHECK(entries(folder.path()) == 1);
  write_text_file(folder / "a.txt", "after", Lasting::yes);
  CHECK(read_text_file(folder / "a.txt") == "after");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("what a killed writer leaves goes, what a living one writes stays") {
  const TemporaryFolder folder;
  OtherWriter dead(folder / "dead.dump"), living(folder / "living.dump");
  dead.end();
  CHECK(entries(folder.path()) == 2);
  CHECK_THROWS_WITH(PackingSeries({folder / "*.dump"}), Contains("no file has such a name"));
  remove_leftovers(folder.path());
  CHECK(entries(folder.path()) == 1);
  CHECK(fs::exists(temporary_name(folder / "living.dump")));
  living.end();
  write_text_file(folder / "other.dump", "whole");  // the first file of this process here
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("two processes do not write the same file") {
  const TemporaryFolder folder;
  OtherWriter other(folder / "a.txt");
  CHECK_THROWS_WITH(write_text_file(folder / "a.txt", "mine"), Contains("a.txt: another process is writing it"));
  other.end();
  write_text_file(folder / "a.txt", "mine");
  CHECK(read_text_file(folder / "a.txt") == "mine");
}

TEST_CASE("a disk without room is an error that says so, and leaves what was there") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "before";
  fs::create_symlink("/dev/full", temporary_name(folder / "a.txt"));
  CHECK_THROWS_WITH(write_text_file(folder / "a.txt", "after"), Contains("a.txt: cannot be written: No space left"));
  CHECK(read_text_file(folder / "a.txt") == "before");
  CHECK(entries(folder.path()) == 1);
  CHECK_THROWS_WITH(append_to_file("/dev/full", "more"), Contains("No space left"));
  CHECK_THROWS_WITH(write_text_file(folder / "none" / "a.txt", ""), Contains("No such file or directory"));
  append_to_file(folder / "a.txt", ", after");
  CHECK(read_text_file(folder / "a.txt") == "before, after");
}
