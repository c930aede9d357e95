#include <cstdio>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/movie.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

Image frame(int width, int height, int shade) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3, static_cast<std::uint8_t>(shade))};
}

std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  CHECK(pclose(pipe) == 0);
  return text;
}

}  // namespace

TEST_CASE("a movie has all its frames") {
  testing::TemporaryFolder folder;
  for (const char* name : {"a.mp4", "a.gif"}) {
    MovieWriter movie(folder / name, 64, 48, {25});
    for (int i = 0; i < 7; ++i) movie.add(frame(64, 48, 30 * i));
    CHECK_FALSE(fs::exists(folder / name));
    movie.finish();
    const std::string probed =
        output_of("ffprobe -v error -count_frames -show_entries stream=width,height,nb_read_frames -of csv=p=0 '" +
                  (folder / name).string() + "'");
    CHECK(probed == "64,48,7\n");
  }
}

TEST_CASE("a movie that cannot be written is refused before a frame is drawn") {
  testing::TemporaryFolder folder;
  CHECK_THROWS_WITH(MovieWriter(folder / "missing/a.mp4", 640, 480, {25}),
                    Contains("missing/a.mp4: cannot be written: No such file or directory"));
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a movie on a full disk is an error, however late that shows") {
  testing::TemporaryFolder folder;
  for (const char* name : {"a.mp4", "a.gif"}) {
    for (const int frames : {1, 40}) {
      INFO(name << ", " << frames << " frames");
      fs::create_symlink("/dev/full", temporary_name(folder / name));  // where every write fails for want of room
      const auto write = [&] {
        MovieWriter movie(folder / name, 64, 48, {25});
        for (int i = 0; i < frames; ++i) movie.add(frame(64, 48, i));
        movie.finish();
      };
      CHECK_THROWS_WITH(write(), Contains("ffmpeg") && Contains("No space left on device"));
      CHECK(fs::is_empty(folder.path()));
    }
  }
}

TEST_CASE("without ffmpeg there is a clear error") {
  testing::TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  CHECK_THROWS_AS(MovieWriter(folder / "a.mp4", 64, 48, {25}), RunError);
  CHECK_THROWS_WITH(MovieWriter(folder / "a.mp4", 64, 48, {25}), Contains("ffmpeg"));
  setenv("PATH", path.c_str(), 1);
}

TEST_CASE("a movie given up leaves nothing behind") {
  testing::TemporaryFolder folder;
  {
    MovieWriter movie(folder / "a.mp4", 64, 48, {25});
    movie.add(frame(64, 48, 1));
  }
  CHECK(fs::is_empty(folder.path()));
  MovieWriter none(folder / "b.mp4", 64, 48, {25});
  CHECK_THROWS_AS(none.finish(), RunError);
}

TEST_CASE("bad movie requests are refused with what would be right") {
  testing::TemporaryFolder folder;
  CHECK_THROWS_WITH(MovieWriter(folder / "a.mp4", 641, 480, {25}), Contains("642 x 480 px would be right"));
  CHECK_THROWS_AS(MovieWriter(folder / "a.mp4", 641, 480, {25}), InputError);
  CHECK_NOTHROW(MovieWriter(folder / "a.gif", 641, 479, {25}));
  CHECK_THROWS_AS(MovieWriter(folder / "a.avi", 640, 480, {25}), InputError);
  CHECK_THROWS_AS(MovieWriter(folder / "a.mp4", 640, 480, {0}), InputError);
  MovieWriter movie(folder / "a.mp4", 64, 48, {25});
  CHECK_THROWS_AS(movie.add(frame(64, 50, 0)), InputError);
}
