#include "io/encoder_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace overfly {
namespace {

constexpr int kPatience_ms = 20;  // between two looks at a program that is waited for

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

std::unique_ptr<EncoderProcess> EncoderProcess::start(const std::vector<std::string>& arguments,
                                                      std::function<void()> while_waiting) {
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
    return std::unique_ptr<EncoderProcess>(
        new EncoderProcess(process, ends[0], std::move(errors), std::move(while_waiting)));
}

EncoderProcess::EncoderProcess(int process, int socket, std::unique_ptr<std::FILE, Close> errors,
                               std::function<void()> while_waiting)
    : process_(process), socket_(socket), errors_(std::move(errors)), while_waiting_(std::move(while_waiting)) {}

EncoderProcess::~EncoderProcess() {
    close_stream();
    if (process_ == 0) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

void EncoderProcess::wait_until_it_reads() const {
    pollfd reader = {.fd = socket_, .events = POLLOUT, .revents = 0};
    while (poll(&reader, 1, kPatience_ms) <= 0) {
        if (while_waiting_) while_waiting_();
    }
}

bool EncoderProcess::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        wait_until_it_reads();
        const ssize_t sent = send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool EncoderProcess::finish() {
    close_stream();
    int status = 0;
    pid_t ended = 0;
    while ((ended = waitpid(process_, &status, WNOHANG)) != process_) {
        if (ended < 0 && errno != EINTR) throw_system_error(errno, "waitpid");
        std::this_thread::sleep_for(std::chrono::milliseconds(kPatience_ms));
        if (while_waiting_) while_waiting_();
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
