/// While it lives, the installed geoid is the ellipsoid: worlds can be turned about the Earth's axis and stay what they are.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::test_support {

class FlatGeoid {
public:
    FlatGeoid() {
        if (const char* before = std::getenv("PROJ_DATA")) before_ = before;
        folder_.write("egm96_15.gtx", grid());
        setenv("PROJ_DATA", folder_.path().c_str(), 1);
    }
    ~FlatGeoid() { before_ ? setenv("PROJ_DATA", before_->c_str(), 1) : unsetenv("PROJ_DATA"); }
    FlatGeoid(const FlatGeoid&) = delete;
    FlatGeoid& operator=(const FlatGeoid&) = delete;

private:
    /// Zero at every 15 degrees.
    static std::string grid() {
        constexpr std::int32_t kRows = 13, kColumns = 24;
        std::string bytes;
        for (const double number : {-90.0, -180.0, 15.0, 15.0}) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &number, sizeof bits);
            for (int n = 56; n >= 0; n -= 8) bytes += static_cast<char>(bits >> n);
        }
        for (const std::int32_t number : {kRows, kColumns})
            for (int n = 24; n >= 0; n -= 8) bytes += static_cast<char>(number >> n);
        return bytes + std::string(std::size_t{4} * kRows * kColumns, '\0');
    }

    TemporaryFolder folder_;
    std::optional<std::string> before_;
};

}  // namespace tedavis::test_support
