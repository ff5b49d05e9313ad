#include "core/error.h"

#include <utility>

namespace overfly {

std::string Place::text() const {
    std::string s = file.string();
    if (line > 0) s += ':' + std::to_string(line) + ':' + std::to_string(column);
    return s;
}

std::string Problem::text() const {
    const std::string where = place.text();
    return where.empty() ? message : where + ": " + message;
}

UserError::UserError(std::vector<Problem> problems) : problems_(std::move(problems)) {
    for (const Problem& p : problems_) {
        if (!what_.empty()) what_ += '\n';
        what_ += p.text();
    }
}

UserError::UserError(Place place, std::string message)
    : UserError(std::vector<Problem>{{std::move(place), std::move(message)}}) {}

}  // namespace overfly
