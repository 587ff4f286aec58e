#include "platform/egl_kms/seat_offer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_seat_offer {
namespace {

using ::testing::HasSubstr;

/// A socket that somebody listens on, as seatd does.
struct Listener {
    explicit Listener(const std::string& path) : file(::socket(AF_UNIX, SOCK_STREAM, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
        EXPECT_EQ(::bind(file, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        EXPECT_EQ(::listen(file, 4), 0);
    }
    ~Listener() { ::close(file); }
    int file;
};

/// Root may open everything.
struct AsNobody {
    AsNobody() : was_root(::geteuid() == 0) { EXPECT_EQ(was_root ? ::seteuid(65534) : 0, 0); }
    ~AsNobody() { EXPECT_EQ(was_root ? ::seteuid(0) : 0, 0); }
    bool was_root;
};

struct SeatOfferOf : testing::Test {
    void SetUp() override {
        if (!can_use_seats()) GTEST_SKIP() << "libseat was missing at the build";
        signs.socket = socket.c_str();
    }
    test_support::TemporaryFolder folder;
    const std::string socket = folder.file("seatd.sock");
    SeatSigns signs;
};

TEST_F(SeatOfferOf, SeatdIsThereWhereItListens) {
    EXPECT_FALSE(find_seat(signs).is_there);
    EXPECT_TRUE(find_seat(signs).text.empty()) << "a board without seatd has nothing to be told";
    {
        const Listener seatd(socket);
        EXPECT_TRUE(find_seat(signs).is_there);
        EXPECT_EQ(find_seat(signs).text.view(), "seatd at " + socket);
    }
    EXPECT_FALSE(find_seat(signs).is_there) << "the socket that an ended seatd leaves";
    EXPECT_TRUE(find_seat(signs).text.empty());
}

TEST_F(SeatOfferOf, AUserWhoMayNotReachSeatdIsToldHowToMendIt) {
    const Listener seatd(socket);
    ASSERT_EQ(::chmod(folder.file("").c_str(), 0755), 0);
    ASSERT_EQ(::chmod(socket.c_str(), 0), 0);
    const AsNobody user;
    const SeatOffer offer = find_seat(signs);
    EXPECT_FALSE(offer.is_there);
    EXPECT_THAT(std::string(offer.text.view()),
                HasSubstr("seatd runs, but this user may not reach it (" + socket + ": Permission denied); `usermod -aG "));
}

TEST_F(SeatOfferOf, ASessionOnAConsoleIsLogindsAndSeatdGoesBeforeIt) {
    signs.session = "";
    EXPECT_FALSE(find_seat(signs).is_there);
    signs.session = "seat0";
    EXPECT_EQ(find_seat(signs).text.view(), "logind, for a session on seat0");
    EXPECT_TRUE(find_seat(signs).is_there);
    const Listener seatd(socket);
    EXPECT_EQ(find_seat(signs).text.view(), "seatd at " + socket);
}

TEST_F(SeatOfferOf, RootGetsASeatOnlyFromABackendThatItNames) {
    const Listener seatd(socket);
    signs.session = "seat0";
    signs.is_root = true;
    EXPECT_FALSE(find_seat(signs).is_there);
    EXPECT_TRUE(find_seat(signs).text.empty());
    signs.backend = "seatd";
    EXPECT_TRUE(find_seat(signs).is_there);
    EXPECT_EQ(find_seat(signs).text.view(), "seatd, by LIBSEAT_BACKEND");
}

TEST_F(SeatOfferOf, APathThatIsTooLongIsSaid) {
    const std::string path = "/" + std::string(200, 'x');
    signs.socket = path.c_str();
    EXPECT_FALSE(find_seat(signs).is_there);
    EXPECT_THAT(std::string(find_seat(signs).text.view()), HasSubstr("File name too long"));
}

/// A build without libseat offers nothing, whatever the user asks for.
TEST(SeatOffer, OnlyTheLibraryCanOfferASeat) {
    SeatSigns signs;
    signs.backend = "seatd";
    EXPECT_EQ(find_seat(signs).is_there, can_use_seats());
    EXPECT_EQ(find_seat(signs).text.empty(), !can_use_seats());
}

}  // namespace
}  // namespace tedavis::platform::test_seat_offer
