#include "viz/movie.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/files.hpp"

namespace packstone::viz {

namespace {

namespace fs = std::filesystem;

constexpr useconds_t interval = 1000;  ///< to ask whether ffmpeg has ended [us]

std::vector<std::string> ffmpeg_call(const fs::path& output, int width, int height, int frames_per_second) {
  std::vector<std::string> call = {"ffmpeg",
                                   "-nostdin",
                                   "-loglevel",
                                   "error",
                                   "-xerror",
                                   "-f",
                                   "rawvideo",
                                   "-pix_fmt",
                                   "rgb24",
                                   "-s",
                                   fmt::format("{}x{}", width, height),
                                   "-framerate",
                                   fmt::format("{}", frames_per_second),
                                   "-i",
                                   "pipe:0"};
  std::vector<std::string> format;
  if (output.extension() == ".gif") {
    // One palette from all frames, so that colours do not flicker.
    format = {"-vf", "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=none", "-loop", "0"};
  } else {
    format = {"-c:v",
              "libx264",
              "-crf",
              "18",
              "-pix_fmt",
              "yuv420p",
              "-vf",
              "scale=out_color_matrix=bt709:out_range=tv",
              "-colorspace",
              "bt709",
              "-color_primaries",
              "bt709",
              "-color_trc",
              "bt709",
              "-movflags",
              "+faststart"};
  }
  call.insert(call.end(), format.begin(), format.end());
  call.insert(call.end(), {"-y", output.string()});
  return call;
}

void check_request(const fs::path& path, int width, int height, int frames_per_second) {
  const std::string ending = path.extension().string();
  if (ending != ".mp4" && ending != ".gif") {
    throw InputError(fmt::format("{}: a movie's ending is .mp4 or .gif", path.string()));
  }
  if (width < 1 || height < 1) throw InputError("a movie has at least 1 x 1 px");
  if (ending == ".mp4" && (width % 2 != 0 || height % 2 != 0)) {
    throw InputError(fmt::format("an .mp4 needs even sides, not {} x {} px; {} x {} px would be right", width, height,
                                 width + width % 2, height + height % 2));
  }
  if (frames_per_second < 1) {
    throw InputError(fmt::format("a movie takes 1 frame a second or more, not {}", frames_per_second));
  }
}

}  // namespace

/// The running ffmpeg. It reads from a socket, as writing to one whose reader has died need not raise SIGPIPE. Its
/// words go into a pipe, which a full disk does not hinder; what is more than the pipe holds is lost.
class MovieWriter::Encoder {
 public:
  /// film: its name, for messages.
  Encoder(const std::vector<std::string>& call, std::string film) : film_(std::move(film)) {
    std::array<int, 2> ends;
    std::array<int, 2> words;
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail_to_start(errno);
    if (pipe2(words.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
      const int error = errno;
      ::close(ends[0]);
      ::close(ends[1]);
      fail_to_start(error);
    }
    input_ = ends[0];
    words_ = words[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, words[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, words[1], STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : call) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error = posix_spawnp(&child_, call.front().c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    ::close(words[1]);
    if (error != 0) {
      child_ = 0;
      close_all();
      fail_to_start(error);
    }
  }

  ~Encoder() {
    if (child_ != 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    close_all();
  }

  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void write(const std::vector<std::uint8_t>& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count = send(input_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(wait_for_end());
      sent += static_cast<std::size_t>(count);
    }
  }

  /// A full disk that shows only when the last bytes are written does not change ffmpeg's exit code, but its words.
  void finish(const std::function<void()>& while_waiting) {
    const int status = wait_for_end(while_waiting);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !first_line_.empty()) fail(status);
  }

 private:
  [[noreturn]] static void fail_to_start(int error) {
    throw RunError(fmt::format("cannot start the program ffmpeg, which writes the movie: {}", std::strerror(error)));
  }

  int wait_for_end(const std::function<void()>& while_waiting = {}) {
    ::close(input_);
    input_ = -1;
    int status = 0;
    while (waitpid(child_, &status, WNOHANG) == 0) {
      if (while_waiting) while_waiting();
      usleep(interval);
    }
    child_ = 0;
    first_line_ = read_first_line();
    return status;
  }

  /// Of what ffmpeg printed: it names the cause, later ones what came of it.
  std::string read_first_line() const {
    std::array<char, 1024> words;
    const ssize_t count = read(words_, words.data(), words.size());
    const std::string text(words.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    const std::size_t first = text.find_first_not_of("\r\n");
    return first == std::string::npos ? "" : text.substr(first, text.find_first_of("\r\n", first) - first);
  }

  [[noreturn]] void fail(int status) {
    std::string reason = first_line_;
    if (reason.empty()) reason = WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "it gives no reason";
    throw RunError(fmt::format("{}: cannot be written: ffmpeg: {}", film_, reason));
  }

  void close_all() {
    if (input_ >= 0) ::close(input_);
    if (words_ >= 0) ::close(words_);
    input_ = words_ = -1;
  }

  std::string film_;
  pid_t child_ = 0;
  int input_ = -1;
  int words_ = -1;
  std::string first_line_;
};

MovieWriter::MovieWriter(const fs::path& path, int width, int height, const MovieOptions& options)
    : width_(width), height_(height) {
  check_request(path, width, height, options.frames_per_second);
  file_ = std::make_unique<PendingFile>(path);
  encoder_ =
      std::make_unique<Encoder>(ffmpeg_call(file_->name(), width, height, options.frames_per_second), path.string());
}

MovieWriter::~MovieWriter() = default;  // ends ffmpeg before its file goes

void MovieWriter::add(const Image& frame) {
  if (frame.width != width_ || frame.height != height_) {
    throw InputError(fmt::format("a frame of {} x {} px does not fit a movie of {} x {} px", frame.width, frame.height,
                                 width_, height_));
  }
  encoder_->write(frame.rgb);
  ++frames_;
}

void MovieWriter::finish(const std::function<void()>& while_waiting) {
  if (frames_ == 0) throw RunError(fmt::format("{}: the movie has no frames", file_->target().string()));
  encoder_->finish(while_waiting);
  file_->commit();
}

}  // namespace packstone::viz
