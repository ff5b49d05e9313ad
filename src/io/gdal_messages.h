#pragma once

#include <string>
#include <vector>

namespace overfly {

// While it lives, what GDAL and PROJ say on this thread is kept here and nothing of it reaches standard error. They
// nest. The first one made registers GDAL's drivers. REQUIRES: dies on the thread that made it, innermost first.
class GdalMessages {
  public:
    GdalMessages();
    ~GdalMessages();
    GdalMessages(const GdalMessages&) = delete;
    GdalMessages& operator=(const GdalMessages&) = delete;

    [[nodiscard]] bool has_failure() const { return !failures_.empty(); }
    // The failures (not the warnings) in one line; "no reason given" where there are none.
    [[nodiscard]] std::string text() const;

  private:
    friend struct GdalMessageCollector;
    std::vector<std::string> failures_;
};

}  // namespace overfly
