// The frames of films as files: kept beside the film, and as vectors.
#include <filesystem>

#include <catch2/catch.hpp>

#include "core/files.hpp"
#include "small_run.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::packstone_command;
using testing::SmallRun;
namespace fs = std::filesystem;

namespace {

void done(const std::string& call) {
  const auto result = packstone_command(call);
  INFO(call << "\n" << result.output);
  REQUIRE(result.exit_code == 0);
}

std::size_t count_in(const fs::path& folder) {
  const fs::directory_iterator files(folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

/// Both folders hold the same files.
void check_same(const fs::path& a, const fs::path& b, std::size_t count) {
  CHECK(count_in(a) == count);
  CHECK(count_in(b) == count);
  for (const auto& file : fs::directory_iterator(a)) {
    INFO(file.path());
    CHECK((read_text_file(file.path()) == read_text_file(b / file.path().filename())));
  }
}

}  // namespace

TEST_CASE("the frames of a film are kept on request, as a folder has them") {
  const SmallRun run;
  const std::string look = " --size 320x240 --supersampling 1 --quiet";
  const fs::path& folder = run.folder.path();
  for (const std::string& call :
       {"render " + run.path + look + " --color speed", "slice " + run.path + look + " --sweep z=10mm:0.2:5"}) {
    done(call + run.out("frames"));
    done(call + run.out("plain.mp4"));
    for (const char* workers : {"1", "2"}) {
      done(call + run.out("film.mp4") + " --workers " + workers + " --keep-frames " + (folder / "kept/here").string());
      check_same(folder / "frames", folder / "kept/here", 5);
      CHECK((read_text_file(folder / "film.mp4") == read_text_file(folder / "plain.mp4")));
      fs::remove_all(folder / "kept");
    }
    fs::remove_all(folder / "frames");
  }
}

TEST_CASE("frames of slices are vectors on request, each the file that its slice alone would be") {
  const SmallRun run;
  const fs::path& folder = run.folder.path();
  const std::string look = " --color speed --range 0:1 --ground dark --title \"A sweep\"";
  for (const std::string size : {" --size 320x240", " --width-mm 85 --height-mm 55"}) {
    for (const std::string format : {"svg", "pdf", "png"}) {
      const std::string call = "slice " + run.path + look + size;
      const auto frames = [&](const std::string& name, const std::string& options) {
        fs::remove_all(folder / name);
        done(call + run.out(name) + " --quiet --frame-format " + format + options);
      };
      frames("one", " --sweep z=10mm:30mm:3 --workers 1");
      frames("two", " --sweep z=10mm:30mm:3 --workers 2");
      check_same(folder / "one", folder / "two", 3);
      if (format == "png") {  // not the same file: its recipe says how it was made
        const bool on_paper = size.find("mm") != std::string::npos;
        CHECK((read_text_file(folder / "one/frame_000001.png").find("pHYs") != std::string::npos) == on_paper);
        continue;
      }
      done(call + " --plane z=20mm" + run.out("alone." + format));
      CHECK((read_text_file(folder / "one" / ("frame_000001." + format)) ==
             read_text_file(folder / ("alone." + format))));
      frames("time", " --plane z=20mm --frames 0:4:2");
      CHECK(count_in(folder / "time") == 3);
      CHECK((read_text_file(folder / "time" / ("frame_000004." + format)) ==
             read_text_file(folder / ("alone." + format))));
    }
  }
  done("slice " + run.path + look + " --size 320x240 --quiet --sweep z=10mm:30mm:3 --frame-format pdf --keep-frames " +
       (folder / "kept").string() + run.out("film.gif"));
  done("slice " + run.path + look + " --size 320x240 --quiet --sweep z=10mm:30mm:3" + run.out("plain.gif"));
  CHECK(fs::exists(folder / "kept/frame_000002.pdf"));
  CHECK(count_in(folder / "kept") == 3);
  CHECK((read_text_file(folder / "film.gif") == read_text_file(folder / "plain.gif")));
}

TEST_CASE("frames are kept of films alone, and have a format where they are files") {
  const SmallRun run;
  const std::string slice = "slice " + run.path + " --size 320x240", kept = " --keep-frames " + run.path + "/kept";
  for (const auto& [call, words] :
       {std::pair<std::string, const char*>{"render " + run.path + run.out("x.png") + kept, "is no .mp4 or .gif"},
        {"render " + run.path + run.out("x") + kept, "is no .mp4 or .gif"},
        {slice + " --plane z=20mm" + run.out("x.svg") + kept, "is no .mp4 or .gif"},
        {slice + " --plane z=20mm" + run.out("x.svg") + " --frame-format svg", "of frames in a folder"},
        {slice + " --sweep z=0:20mm:3" + run.out("x.mp4") + " --frame-format svg", "of frames in a folder"},
        {slice + " --sweep z=0:20mm:3" + run.out("x") + " --frame-format jpg", "jpg"}}) {
    const auto result = packstone_command(call);
    INFO(call << "\n" << result.output);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.output, Contains(words));
    for (const char* name : {"x", "x.png", "x.svg", "x.mp4", "run/kept"}) CHECK_FALSE(fs::exists(run.folder / name));
  }
}
