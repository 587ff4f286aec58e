/// Keeps GDAL from printing: its faults become our one sentence. While an object lives, this thread's messages are only
/// remembered.
#pragma once

#include <cpl_error.h>

#include <string>

namespace tedavis::host_sim {

class QuietGdal {
public:
    QuietGdal() {
        CPLPushErrorHandler(CPLQuietErrorHandler);
        CPLErrorReset();
    }
    ~QuietGdal() { CPLPopErrorHandler(); }
    QuietGdal(const QuietGdal&) = delete;
    QuietGdal& operator=(const QuietGdal&) = delete;

    /// What GDAL said last, on one line.
    [[nodiscard]] static std::string last_message() {
        std::string text = CPLGetLastErrorMsg();
        for (char& c : text) c = c == '\n' || c == '\r' ? ' ' : c;
        return text.empty() ? "no reason given" : text;
    }
};

}  // namespace tedavis::host_sim
