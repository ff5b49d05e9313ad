#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace overfly {

// Where a problem is: a file, and a line and column (from 1) where the file is a text that has them, else 0.
struct Place {
    std::filesystem::path file;
    int line = 0;
    int column = 0;

    [[nodiscard]] std::string text() const;  // "file:line:column", "file", or ""
};

// One thing that the user can mend. The message says the key or part, what came and what is allowed.
struct Problem {
    Place place;
    std::string message;

    [[nodiscard]] std::string text() const;  // one line: "place: message"
};

// Everything found wrong with what the user gave, at once. The program prints a line each and exits with 2.
class UserError : public std::exception {
  public:
    explicit UserError(std::vector<Problem> problems);
    UserError(Place place, std::string message);

    [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
    [[nodiscard]] const char* what() const noexcept override { return what_.c_str(); }

  private:
    std::vector<Problem> problems_;
    std::string what_;
};

// An invariant of our own that must hold whatever the input; on in every build. A failure is our bug, exit 1.
class InternalError : public std::exception {
  public:
    explicit InternalError(std::string message) : message_(std::move(message)) {}
    [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }

  private:
    std::string message_;
};

// Throws InternalError with `rule` when it does not hold.
inline void check(bool holds, const char* rule) {
    if (!holds) throw InternalError(rule);
}

}  // namespace overfly
