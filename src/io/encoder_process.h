#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace overfly {

// A program that reads a stream from us. Started without a shell, so nothing in its arguments needs quoting; a program
// that ends early is an error that we see, not a signal that ends us.
class EncoderProcess {
  public:
    // `arguments` begin with the program's name, which is looked for in PATH. Returns nothing when it is not installed.
    // while_waiting: called many times a second while the program keeps us waiting; may throw.
    [[nodiscard]] static std::unique_ptr<EncoderProcess> start(const std::vector<std::string>& arguments,
                                                               std::function<void()> while_waiting = {});
    // Ends a program that was not waited for.
    ~EncoderProcess();
    EncoderProcess(const EncoderProcess&) = delete;
    EncoderProcess& operator=(const EncoderProcess&) = delete;

    // False once the program no longer reads.
    [[nodiscard]] bool write(std::span<const std::uint8_t> bytes);

    // Ends the stream and waits. Returns whether the program ended well.
    [[nodiscard]] bool finish();
    // What it wrote on its standard error, as far as it has got.
    [[nodiscard]] std::string complaints() const;

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    EncoderProcess(int process, int socket, std::unique_ptr<std::FILE, Close> errors,
                   std::function<void()> while_waiting);
    void wait_until_it_reads() const;
    void close_stream();

    int process_;  // 0 once it was waited for
    int socket_;   // -1 once it is closed
    std::unique_ptr<std::FILE, Close> errors_;
    std::function<void()> while_waiting_;
};

}  // namespace overfly
