/// Keeps GDAL from printing, so that its faults become part of one message. While an object exists, this thread's messages are
/// only stored.
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
