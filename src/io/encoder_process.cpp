#include "io/encoder_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace overfly {
namespace {

[[noreturn]] void throw_system_error(int error_number, const char* what) {
    throw std::system_error(error_number, std::generic_category(), what);
}

// Which of our file descriptors the program gets as its standard input, output and error.
class SpawnActions {
  public:
    SpawnActions(int input, int errors) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
    }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::unique_ptr<EncoderProcess> EncoderProcess::start(const std::vector<std::string>& arguments) {
    // A file, not a pipe: nobody has to read it while the program runs.
    std::unique_ptr<std::FILE, Close> errors(std::tmpfile());
    if (!errors) throw_system_error(errno, "temporary file");
    // A socket, not a pipe: only a socket can be told to report a reader that is gone without the signal SIGPIPE.
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw_system_error(errno, "socket");

    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const SpawnActions actions(ends[1], fileno(errors.get()));
    pid_t process = 0;
    const int error_number = posix_spawnp(&process, argv.front(), actions.get(), nullptr, argv.data(), environ);
    close(ends[1]);
    if (error_number != 0) {
        close(ends[0]);
        if (error_number == ENOENT) return nullptr;
        throw_system_error(error_number, argv.front());
    }
    return std::unique_ptr<EncoderProcess>(new EncoderProcess(process, ends[0], std::move(errors)));
}

EncoderProcess::EncoderProcess(int process, int socket, std::unique_ptr<std::FILE, Close> errors)
    : process_(process), socket_(socket), errors_(std::move(errors)) {}

EncoderProcess::~EncoderProcess() {
    close_stream();
    if (process_ == 0) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

bool EncoderProcess::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool EncoderProcess::finish() {
    close_stream();
    int status = 0;
    while (waitpid(process_, &status, 0) < 0) {
        if (errno != EINTR) throw_system_error(errno, "waitpid");
    }
    process_ = 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string EncoderProcess::complaints() const {
    std::string text(2048, '\0');
    const ssize_t length = pread(fileno(errors_.get()), text.data(), text.size(), 0);
    text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

void EncoderProcess::close_stream() {
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
}

}  // namespace overfly
