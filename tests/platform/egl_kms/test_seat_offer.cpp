#include "platform/egl_kms/seat_offer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
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

/// The name of the file's group, as the system's table has it, or its number where the table does not.
std::string group_of(const std::string& path) {
    struct stat file {};
    EXPECT_EQ(::stat(path.c_str(), &file), 0);
    std::ifstream table("/etc/group");  // "name:x:number:members"
    std::string number = std::to_string(file.st_gid);
    for (std::string line; std::getline(table, line);) {
        const std::size_t name_end = line.find(':'), begin = line.find(':', name_end + 1) + 1;
        if (line.substr(begin, line.find(':', begin) - begin) == number) return line.substr(0, name_end);
    }
    return number;
}

struct SeatOfferOf : testing::Test {
    void SetUp() override {
        ASSERT_TRUE(can_use_seats()) << "libseat was missing at the build; toolchains/install_packages core installs it";
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
    const std::string group = group_of(socket);
    const AsNobody user;
    struct stat seen {};
    ASSERT_EQ(::stat(socket.c_str(), &seen), 0)
        << "the folder for temporary files is closed to user 65534; set TMPDIR to another";
    const SeatOffer offer = find_seat(signs);
    EXPECT_FALSE(offer.is_there);
    EXPECT_THAT(std::string(offer.text.view()),
                HasSubstr("seatd runs, but this user may not reach it (" + socket + ": Permission denied); `usermod -aG " +
                          group + " USER`, then log in again"));
}

TEST_F(SeatOfferOf, ASessionOnAConsoleIsLogindsAndSeatdGoesBeforeIt) {
    signs.session = "";
    EXPECT_FALSE(find_seat(signs).is_there);
    signs.session = "seat0";
    EXPECT_EQ(find_seat(signs).text.view(), "logind (session on seat0)");
    EXPECT_TRUE(find_seat(signs).is_there);
    const Listener seatd(socket);
    EXPECT_EQ(find_seat(signs).text.view(), "seatd at " + socket);
}

TEST_F(SeatOfferOf, RootGetsASeatOnlyFromABackendThatItNames) {
    const Listener seatd(socket);
    signs.session = "seat0";
    signs.is_root = true;
    EXPECT_FALSE(find_seat(signs).is_there);
    EXPECT_EQ(find_seat(signs).text.view(), "root asks a seat manager only where LIBSEAT_BACKEND names one");
    signs.backend = "seatd";
    EXPECT_TRUE(find_seat(signs).is_there);
    EXPECT_EQ(find_seat(signs).text.view(), "seatd (by LIBSEAT_BACKEND)");
}

TEST_F(SeatOfferOf, WhatIsSetAndEmptyNamesNothingAsForLibseat) {
    const Listener seatd(socket);
    signs.backend = "";
    EXPECT_FALSE(find_seat(signs).is_there);
    EXPECT_EQ(find_seat(signs).text.view(), "LIBSEAT_BACKEND is set and empty; unset it");
    signs.backend = nullptr;
    signs.socket = "";
    EXPECT_FALSE(find_seat(signs).is_there);
    EXPECT_TRUE(find_seat(signs).text.empty());
}

TEST_F(SeatOfferOf, APathThatIsTooLongIsSaid) {
    const std::string path = "/" + std::string(200, 'x');
    signs.socket = path.c_str();
    EXPECT_FALSE(find_seat(signs).is_there);
    EXPECT_THAT(std::string(find_seat(signs).text.view()), HasSubstr("File name too long"));
}

/// A build without libseat offers nothing, whatever the user asks for, and says so.
TEST(SeatOffer, OnlyTheLibraryCanOfferASeat) {
    SeatSigns signs;
    signs.backend = "seatd";
    EXPECT_EQ(find_seat(signs).is_there, can_use_seats());
    EXPECT_EQ(find_seat(signs).text.view(),
              can_use_seats() ? "seatd (by LIBSEAT_BACKEND)" : "this build uses no seat managers, since libseat was missing");
}

}  // namespace
}  // namespace tedavis::platform::test_seat_offer
