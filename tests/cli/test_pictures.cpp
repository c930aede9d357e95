// The picture verbs from the outside: what they write, and one line for each wrong call.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "command.hpp"
#include "core/files.hpp"
#include "small_run.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using testing::packstone_command;
using testing::SmallRun;
using testing::TemporaryFolder;

namespace {

/// From the pixels on, without the texts that say how the picture was made.
std::string pixels_of(const std::filesystem::path& path) {
  const std::string file = read_text_file(path);
  return file.substr(file.find("IDAT"));
}

/// Without the text behind them that says what drew the walls.
std::string pixels_until_renderer(const std::filesystem::path& path) {
  const std::string pixels = pixels_of(path);
  const std::size_t length_of_chunk = 4;
  return pixels.substr(0, pixels.find("tEXtRenderer") - length_of_chunk);
}

/// The text chunk that a picture's making is in.
std::string recipe_of(const std::filesystem::path& path) {
  const std::string file = read_text_file(path), key = "tEXtRecipe";
  const std::size_t at = file.find(key);
  REQUIRE(at != std::string::npos);
  std::size_t length = 0;
  for (std::size_t k = at - 4; k < at; ++k) length = length << 8 | static_cast<unsigned char>(file[k]);
  const std::size_t head = std::string("Recipe").size() + 1;
  return file.substr(at + 4 + head, length - head);
}

bool is_png(const std::filesystem::path& path) {
  return std::filesystem::exists(path) && read_text_file(path).substr(1, 3) == "PNG";
}

}  // namespace

TEST_CASE("pictures, a film, a slice, charts and a report come out without a display") {
  const SmallRun run;
  const std::string small = " --size 320x240 --supersampling 1";
  const auto done = [&](const std::string& call, const std::string& environment) {
    const auto result = packstone_command(call, environment);
    INFO(call << "\n" << result.output);
    CHECK(result.exit_code == 0);
  };
  done("render " + run.path + run.out("a.png") + small, "env -u DISPLAY");
  done("render " + run.path + run.out("b.png") + small, "DISPLAY=nowhere:7");
  CHECK(is_png(run.folder / "a.png"));
  CHECK((read_text_file(run.folder / "a.png") == read_text_file(run.folder / "b.png")));
  done("render " + run.path + run.out("speed.png") + small + " --color speed --camera top --at t=0.04", "");
  CHECK(is_png(run.folder / "speed.png"));
  done("render " + run.path + run.out("frames") + small + " --quiet --frames 0:4:2", "");
  CHECK(is_png(run.folder / "frames/frame_000002.png"));
  CHECK_FALSE(std::filesystem::exists(run.folder / "frames/frame_000001.png"));
  done("render " + run.path + run.out("film.mp4") + small + " --quiet", "");
  CHECK(std::filesystem::file_size(run.folder / "film.mp4") > 1000);
  done("slice " + run.path + run.out("cut.svg") + small + " --plane z=20mm", "");
  CHECK_THAT(read_text_file(run.folder / "cut.svg"), Contains("<svg") && Contains("<circle"));
  done("slice " + run.path + run.out("cut.pdf") + small + " --plane z=20mm", "");
  CHECK_THAT(read_text_file(run.folder / "cut.pdf"), StartsWith("%PDF-"));
  const std::string column = " --width-mm 85 --height-mm 55 --font-pt 8 --dpi 300 --title -";
  done("plot " + run.path + " --what energy" + run.out("column.svg") + column, "");
  CHECK_THAT(read_text_file(run.folder / "column.svg"), Contains("width='85mm'") && Contains("font-size='33.33'"));
  done("slice " + run.path + " --plane z=20mm" + run.out("column.png") + column, "");
  CHECK(is_png(run.folder / "column.png"));
  done("plot " + run.path + " --what energy,profile" + run.out("plots"), "");
  CHECK(is_png(run.folder / "plots/energy.png"));
  CHECK(is_png(run.folder / "plots/profile.png"));
  done("plot " + run.path + " " + run.path + " --what mixture" + run.out("mixture.svg"), "");
  CHECK_THAT(read_text_file(run.folder / "mixture.svg"), Contains("Small particles for each big one"));
  done("report " + run.path + run.out("report.html"), "");
  const std::string page = read_text_file(run.folder / "report.html");
  CHECK_THAT(page, Contains("kinetic energy"));
  CHECK_THAT(page, Contains("data:image/png;base64,") && !Contains("<script") && !Contains("src=\"http"));
  done("report " + run.path + " " + run.path + run.out("both.html"), "");
}

TEST_CASE("tiles, parts and workers change no byte of a picture or a film") {
  const SmallRun run;
  const auto made = [&](const std::string& name, const std::string& options) {
    const auto result = packstone_command("render " + run.path + run.out(name) + " --size 322x242 --quiet" + options);
    INFO(options << "\n" << result.output);
    REQUIRE(result.exit_code == 0);
    return read_text_file(run.folder / name);
  };
  const std::string picture = made("one.png", " --workers 1");
  CHECK((made("tiles.png", " --tiles 4x3 --workers 1") == picture));
  CHECK((made("more.png", " --tiles 3x5 --workers 3 --parts 8") == picture));
  const std::string film = made("one.mp4", " --workers 1");
  CHECK((made("more.mp4", " --workers 3 --parts 2") == film));
}

TEST_CASE("a picture names what drew its walls, and a backend that is not there gives one line") {
  const SmallRun run;
  const std::string call = "render " + run.path + run.out("x.png") + " --size 200x150 --backend ";
  REQUIRE(packstone_command(call + "egl --workers 1").exit_code == 0);
  const std::string bytes = read_text_file(run.folder / "x.png");
  CHECK_THAT(bytes, Contains(std::string("Renderer\0EGL ", 13)));
  REQUIRE(packstone_command(call + "egl --workers 2 --tiles 2x2 --quiet").exit_code == 0);
  CHECK((read_text_file(run.folder / "x.png") == bytes));
  REQUIRE(packstone_command(call + "osmesa").exit_code == 0);
  CHECK_THAT(read_text_file(run.folder / "x.png"), Contains(std::string("Renderer\0OSMesa ", 16)));
  const std::string by_osmesa = pixels_until_renderer(run.folder / "x.png");
  std::filesystem::remove(run.folder / "x.png");
  const auto by_vtk = packstone_command(call + "vtk", "DISPLAY=nowhere:7");
  INFO(by_vtk.output);
  if (by_vtk.exit_code == 0) {
    CHECK((pixels_until_renderer(run.folder / "x.png") == by_osmesa));
    std::filesystem::remove(run.folder / "x.png");
  } else {  // VTK was built without such a window
    CHECK(by_vtk.exit_code == 1);
    CHECK(std::count(by_vtk.output.begin(), by_vtk.output.end(), '\n') == 1);
    CHECK_THAT(by_vtk.output, Contains("no off-screen window of its own; there are the backends osmesa and egl"));
  }
  for (const char* workers : {" --workers 1", " --workers 2 --tiles 2x1"}) {
    const auto result = packstone_command(call + "egl" + workers, "__EGL_VENDOR_LIBRARY_DIRS=/nowhere");
    INFO(result.output);
    CHECK(result.exit_code == 1);
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    CHECK_THAT(result.output, Contains("EGL gives no OpenGL context without a screen"));
    CHECK_FALSE(std::filesystem::exists(run.folder / "x.png"));
  }
}

TEST_CASE("the colours of a film span all frames, also where the first is empty") {
  const TemporaryFolder folder;
  std::ofstream dump(folder / "poured.dump");
  const auto frame = [&](int step, const std::string& count, const std::string& atoms) {
    dump << "ITEM: TIMESTEP\n"
         << step << "\nITEM: NUMBER OF ATOMS\n"
         << count << "\nITEM: BOX BOUNDS pp pp ff\n0 0.1\n0 0.1\n0 0.1\nITEM: ATOMS id type x y z radius\n"
         << atoms;
  };
  frame(0, "0", "");
  frame(1, "1", "1 1 0.05 0.05 0.05 0.01\n");
  frame(2, "2", "1 1 0.05 0.05 0.05 0.01\n2 1 0.02 0.05 0.05 0.02\n");
  dump.close();
  const std::string call = "render " + (folder / "poured.dump").string() + " --size 200x150 --quiet --color radius -o ";
  for (const std::string& end : {(folder / "own").string(), (folder / "given").string() + " --range 0.01:0.02"}) {
    const auto result = packstone_command(call + end);
    INFO(result.output);
    REQUIRE(result.exit_code == 0);
  }
  for (const char* name : {"frame_000000.png", "frame_000001.png", "frame_000002.png"}) {
    CHECK(pixels_of(folder.path() / "own" / name) == pixels_of(folder.path() / "given" / name));
  }
}

TEST_CASE("what is drawn among the particles is the same from any workers, tiles and parts") {
  const SmallRun run;
  const std::string call = "render " + run.path + " --size 320x240 --quiet --occlusion 0.5";
  const auto same = [&](const std::string& options, const std::string& a, const std::string& b) {
    for (const auto& [file, shared] : {std::pair<std::string, std::string>{"a", a}, {"b", b}}) {
      const bool film = options.find("--frames") != std::string::npos;
      const auto result = packstone_command(call + options + shared + run.out(file + (film ? "" : ".png")));
      INFO(call + options + shared << "\n" << result.output);
      REQUIRE(result.exit_code == 0);
    }
  };
  for (const std::string options : {" --contacts", " --chains", " --arrows velocity --at 2",
                                    " --trajectories random:5 --particles shrunk", " --contacts --arrows velocity"}) {
    same(options, " --workers 1", " --workers 3 --tiles 4x3 --parts 8");
    CHECK((read_text_file(run.folder / "a.png") == read_text_file(run.folder / "b.png")));
  }
  // Scales are those of all frames, whoever draws them.
  same(" " + run.path + " --titles one,two --contacts --color speed", " --workers 1", " --workers 2 --tiles 3x3");
  CHECK((read_text_file(run.folder / "a.png") == read_text_file(run.folder / "b.png")));
  same(" --frames 1:3 --contacts --arrows velocity", " --workers 1", " --workers 2");
  for (const char* name : {"frame_000001.png", "frame_000002.png", "frame_000003.png"}) {
    CHECK((read_text_file(run.folder.path() / "a" / name) == read_text_file(run.folder.path() / "b" / name)));
  }
}

TEST_CASE("a picture's recipe is a view file that makes it again") {
  const SmallRun run;
  const auto done = [](const std::string& call) {
    const auto result = packstone_command(call);
    INFO(call << "\n" << result.output);
    REQUIRE(result.exit_code == 0);
  };
  const std::string file = (run.folder / "view.toml").string();
  std::ofstream(file) << "preset = \"dark\"\nsize = \"320x240\"\nzoom = 1.5\nfocus = [0.02, \"20 mm\", 0.03]\n"
                         "contacts = true\nchains = false\n";
  done("render " + run.path + " --view " + file + " --camera 40,-10 --size 300x200" + run.out("a.png"));
  const std::string recipe = recipe_of(run.folder / "a.png");
  for (const char* line : {"camera = '40,-10'", "zoom = '1.5'", "size = '300x200'", "ground = 'dark'",
                           "contacts = true", "occlusion = '0.7'"}) {
    CHECK_THAT(recipe, Contains(line));
  }
  CHECK_THAT(recipe, !Contains("workers") && !Contains("output") && !Contains("chains"));
  std::ofstream(file) << recipe;
  done("render " + run.path + " --workers 1 --view=" + file + run.out("b.png"));
  CHECK((read_text_file(run.folder / "a.png") == read_text_file(run.folder / "b.png")));

  std::ofstream(file) << "plane = \"z=20mm\"\n";
  done("slice " + run.path + " --view " + file + " --preset dark" + run.out("c.png"));
  CHECK_THAT(recipe_of(run.folder / "c.png"), Contains("plane = 'z=20mm'") && Contains("ground = 'dark'"));
  done("plot " + run.path + " --what energy --preset dark --width-mm 85 --height-mm 55" + run.out("d.svg"));
  CHECK_THAT(read_text_file(run.folder / "d.svg"), Contains("height='100%' fill='#16181d'"));
}

TEST_CASE("a wrong view file is refused with the place in it") {
  const SmallRun run;
  const std::string file = (run.folder / "view.toml").string();
  const auto refusal = [&](const std::string& text) {
    std::ofstream(file) << text;
    const auto result = packstone_command("render " + run.path + " --view " + file + run.out("x.png"));
    CHECK(result.exit_code == 2);
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(run.folder / "x.png"));
    return result.output;
  };
  CHECK_THAT(refusal("\n  colour = \"speed\""), Contains("view.toml:2:3: unknown key 'colour', did you mean 'color'"));
  CHECK_THAT(refusal("zoom = 2\nocclusion = 7"), Contains("view.toml:2:1: --occlusion"));
  CHECK_THAT(refusal("camera = \"isso\""), Contains("view.toml:1:1: there is no view 'isso'"));
  CHECK_THAT(refusal("workers = 3"), Contains("view.toml:1:1: workers does not belong to a view"));
  CHECK_THAT(refusal("contacts = 1"), Contains("view.toml:1:1: contacts: expected true or false"));
  CHECK_THAT(refusal("zoom = true"), Contains("view.toml:1:1: zoom: expected a text or a number"));
  CHECK_THAT(refusal("preset = \"print\""), Contains("view.toml:1:1: preset print"));
  CHECK_THAT(refusal("[camera]\nzoom = 2"), Contains("view.toml:1:2: camera: expected"));
  CHECK_THAT(refusal("zoom = "), Contains("view.toml:1:") && Contains("not valid TOML"));
}

TEST_CASE("films of slices over planes and over time are the same from any workers, with one scale") {
  const SmallRun run;
  const auto done = [](const std::string& call) {
    const auto result = packstone_command(call);
    INFO(call << "\n" << result.output);
    REQUIRE(result.exit_code == 0);
  };
  const std::string look = " --size 320x240 --supersampling 1 --quiet --color speed";
  const auto same_frames = [&](const std::string& options, const std::vector<std::string>& names) {
    for (const char* workers : {"1", "2"}) {
      const std::string out = (run.folder / ("w" + std::string(workers))).string();
      std::filesystem::remove_all(out);
      done("slice " + options + look + " --workers " + workers + " -o " + out);
      const std::filesystem::directory_iterator files(out);
      CHECK(static_cast<std::size_t>(std::distance(begin(files), end(files))) == names.size());
    }
    for (const std::string& name : names) {
      CHECK((read_text_file(run.folder / "w1" / name) == read_text_file(run.folder / "w2" / name)));
    }
  };
  same_frames(run.path + " --sweep \"z=5 mm:0.03:3\"", {"frame_000000.png", "frame_000001.png", "frame_000002.png"});
  same_frames(run.path + " " + run.path + " --plane z=20mm --frames 1:3:2", {"frame_000001.png", "frame_000003.png"});
  // A frame is the picture of its plane on the film's scale.
  done("slice " + run.path + " --sweep z=0.02:0.021:2 --range 0:1 --workers 1" + look + run.out("planes"));
  done("slice " + run.path + " --plane z=0.021 --range 0:1" + look.substr(0, look.find(" --quiet")) + " --color speed" +
       run.out("plane.png"));
  CHECK(pixels_of(run.folder.path() / "planes" / "frame_000001.png") == pixels_of(run.folder / "plane.png"));
  done("slice " + run.path + " --sweep z=0.01:0.03:4" + look + run.out("sweep.mp4"));
  CHECK(std::filesystem::file_size(run.folder / "sweep.mp4") > 1000);
  done("slice " + run.path + " --plane \"through 20 mm,0.02,0.02 normal 1,1,0\"" + run.out("oblique.svg"));
  CHECK_THAT(read_text_file(run.folder / "oblique.svg"), Contains("normal (0.707, 0.707, 0)") && Contains("<circle"));
}

TEST_CASE("a worker that is killed in the middle of a film leaves no trace in it") {
  const SmallRun run;
  const std::string call = "render " + run.path + " --size 800x600 --supersampling 4 --quiet";
  REQUIRE(packstone_command(call + run.out("whole") + " --workers 1").exit_code == 0);
  // Once there are workers, one of them is killed a little later.
  const std::string children = "/proc/$P/task/$P/children";
  const auto killed =
      testing::shell("(" + std::string(PACKSTONE_COMMAND) + " " + call + run.out("killed") +
                     " --workers 2 & P=$!; for k in $(seq 500); do grep -q . " + children +
                     " && break; sleep 0.01; done; sleep 0.1; kill -9 $(cut -d ' ' -f 1 " + children + ") && wait $P)");
  INFO(killed.output);
  REQUIRE(killed.exit_code == 0);
  int frames = 0;
  for (const auto& file : std::filesystem::directory_iterator(run.folder / "whole")) {
    CHECK((read_text_file(file.path()) == read_text_file(run.folder / "killed" / file.path().filename())));
    ++frames;
  }
  CHECK(frames == 5);
  const std::filesystem::directory_iterator left(run.folder / "killed");
  CHECK(std::distance(begin(left), end(left)) == frames);
}

TEST_CASE("a wrong picture call gives one line, exit code 2 and no file") {
  const SmallRun run;
  for (const std::string& call :
       {"render " + run.path + run.out("x.png") + " --color sped",
        "render " + run.path + run.out("x.jpg"),
        "render " + run.path + run.out("x.png") + " --at 99",
        "render " + run.path + run.out("x.png") + " --size 10",
        "render " + run.path + run.out("x.png") + " --camera side",
        "render " + run.path + run.out("x.png") + " --frames 0:2",
        "render " + run.path + run.out("x.mp4") + " --size 321x240",
        "render " + run.path + run.out("x.mp4") + " --frames 4:1",
        "render " + run.path + run.out("x.png") + " --size 40000x100",
        "render " + run.path + run.out("x.png") + " --tiles 4",
        "render " + run.path + run.out("x.png") + " --tiles 0x3",
        "render " + run.path + run.out("x.mp4") + " --tiles 2x2",
        "render " + run.path + run.out("x.png") + " --workers 0",
        "render " + run.path + run.out("x.png") + " --occlusion 2",
        "render " + run.path + run.out("x.png") + " --cut-through",
        "render " + run.path + run.out("x.png") + " --parts 0",
        "render " + run.path + run.out("x.png") + " --camera 30,100",
        "render " + run.path + run.out("x.png") + " --camera 30,1x",
        "render " + run.path + run.out("x.png") + " --zoom 0",
        "render " + run.path + run.out("x.png") + " --focus 1,2",
        "render " + run.path + run.out("x.png") + " --focus 1,2,3,4",
        "render " + run.path + run.out("x.png") + " --ground grey",
        "render " + run.path + run.out("x.png") + " --particles some",
        "render " + run.path + run.out("x.png") + " --arrows radius",
        "render " + run.path + run.out("x.png") + " --contacts --chains",
        "render " + run.path + run.out("x.png") + " --trajectories 123456",
        "render " + run.path + run.out("x.png") + " --trajectories all",
        "render " + run.path + run.out("x.png") + " --trajectories \"x>9\"",
        "render " + run.path + run.out("x.png") + " --tail 0",
        "render " + run.path + run.out("x.png") + " --force-scale 0",
        "render " + run.path + run.out("x.png") + " --preset print",
        "render " + run.path + run.out("x.png") + " --view /no/such/view.toml",
        "render " + run.path + run.out("x.png") + " --backend glx",
        "render " + run.path + " " + run.path + run.out("x.png") + " --title both",
        "render " + run.path + " " + run.path + run.out("x.png") + " --titles one",
        "render " + run.path + " /no/such/run" + run.out("x.png"),
        "slice " + run.path + run.out("x.png") + " --plane w=1",
        "slice " + run.path + run.out("x.png") + " --plane z=20mm --titles a,b",
        "slice " + run.path + run.out("x.png") + " --plane z=9",
        "slice " + run.path + run.out("x.png"),
        "slice " + run.path + run.out("x.png") + " --plane z=20mm --sweep z=0:20mm:3",
        "slice " + run.path + run.out("x.png") + " --sweep z=0:20mm:3",
        "slice " + run.path + run.out("x.mp4") + " --plane z=20mm",
        "slice " + run.path + run.out("x.mp4") + " --sweep z=0:20mm:1",
        "slice " + run.path + run.out("x.mp4") + " --sweep z=0:20mm",
        "slice " + run.path + run.out("x.mp4") + " --sweep z=0:9:5",
        "slice " + run.path + run.out("x.mp4") + " --sweep z=0:20mm:3 --frames 0:2",
        "slice " + run.path + run.out("x.mp4") + " --plane z=20mm --frames 0:99",
        "slice " + run.path + run.out("x.mp4") + " --plane z=20mm --frames 0:2 --color sped",
        "slice " + run.path + run.out("x.png") + " --plane \"through 0,0,0 normal 0,0,0\"",
        "slice " + run.path + run.out("x.png") + " --plane \"through 9,9,9 normal 1,1,1\"",
        "slice " + run.path + run.out("x.png") + " --plane z=20mm --color category:sped",
        "slice " + run.path + run.out("x.png") + " --plane z=20mm --color category:speed",
        "plot " + run.path + run.out("x.png") + " --what energy --width-mm 85",
        "plot " + run.path + run.out("x.png") + " --what energy --width-mm 85 --height-mm 5",
        "plot " + run.path + run.out("x.png") + " --what energy --width-mm 11 --height-mm 11",
        "plot " + run.path + run.out("x.png") + " --what energy --width-mm 85 --height-mm 55 --dpi nan",
        "plot " + run.path + run.out("x.png") + " --what energy --width-mm 85 --height-mm 55 --font-pt 0",
        "plot " + run.path + run.out("x.png") + " --what energy --width-mm 85 --height-mm 55 --size 100x100",
        "slice " + run.path + run.out("x.pdf") + " --plane z=20mm --font-pt 8",
        "plot " + run.path + run.out("x.png") + " --what enrgy",
        "report " + run.path + run.out("x.pdf"),
        "render /no/such/run" + run.out("x.png")}) {
    const auto result = packstone_command(call);
    INFO(call << "\n" << result.output);
    CHECK(result.exit_code == 2);
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    CHECK_THAT(result.output, StartsWith("packstone: error: "));
    for (const char* name : {"x.png", "x.mp4", "x.jpg", "x.pdf"})
      CHECK_FALSE(std::filesystem::exists(run.folder / name));
  }
  const auto unwritable = packstone_command("render " + run.path + " -o /proc/x.png --size 64x64");
  const auto film =
      packstone_command("slice " + run.path + " --sweep z=0.01:0.03:3 --size 320x240" + run.out("missing/x.mp4"));
  CHECK(film.exit_code == 1);  // at once, without a word about frames drawn
  CHECK(std::count(film.output.begin(), film.output.end(), '\n') == 1);
  CHECK_THAT(film.output, StartsWith("packstone: error: ") && Contains("x.mp4: cannot be written"));
  CHECK(unwritable.exit_code != 0);
  CHECK(std::count(unwritable.output.begin(), unwritable.output.end(), '\n') == 1);
}

TEST_CASE("packstone without the program that draws says so") {
  const TemporaryFolder folder;
  std::filesystem::copy_file(PACKSTONE_COMMAND, folder / "packstone");
  const auto result = testing::shell((folder / "packstone").string() + " render run -o x.png");
  INFO(result.output);
  CHECK(result.exit_code == 2);
  CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
  CHECK_THAT(result.output, Contains("packstone-pictures cannot be started") && Contains("belongs beside packstone"));
}
