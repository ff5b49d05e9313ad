#include "io/gdal_messages.h"

#include <algorithm>
#include <mutex>

#include <cpl_error.h>
#include <gdal.h>

namespace overfly {

struct GdalMessageCollector {
    static void CPL_STDCALL collect(CPLErr level, CPLErrorNum, const char* message) {
        if (level < CE_Failure) return;
        std::vector<std::string>& failures = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->failures_;
        std::string line = message;
        std::replace(line.begin(), line.end(), '\n', ' ');
        // A damaged file says the same for each of its blocks; the first few lines tell all there is to know.
        constexpr std::size_t kMostLines = 3;
        if (failures.size() < kMostLines && std::find(failures.begin(), failures.end(), line) == failures.end())
            failures.push_back(std::move(line));
    }
};

GdalMessages::GdalMessages() {
    static std::once_flag registered;
    std::call_once(registered, GDALAllRegister);
    CPLPushErrorHandlerEx(&GdalMessageCollector::collect, this);
}

GdalMessages::~GdalMessages() {
    CPLPopErrorHandler();
    CPLErrorReset();
}

std::string GdalMessages::text() const {
    if (failures_.empty()) return "no reason given";
    std::string joined = failures_.front();
    for (std::size_t i = 1; i < failures_.size(); ++i) joined += "; " + failures_[i];
    return joined;
}

}  // namespace overfly
