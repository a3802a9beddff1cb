#include "config/listen_address.hpp"

#include <gtest/gtest.h>

namespace autostereo::config {
namespace {

TEST(ListenAddress, AddressesInDigitsWithTheirPort) {
    EXPECT_EQ(listenAddress("127.0.0.1:8787"), (ListenAddress{"127.0.0.1", 8787, true}));
    EXPECT_EQ(listenAddress("127.9.8.7:0"), (ListenAddress{"127.9.8.7", 0, true}));
    EXPECT_EQ(listenAddress("[::1]:65535"), (ListenAddress{"::1", 65535, true}));
}

TEST(ListenAddress, WhatOthersCanReachIsNoLoopback) {
    for (const char* text : {"0.0.0.0:80", "192.168.0.1:80", "128.0.0.1:80", "[::]:80",
                             "[fe80::1]:80", "[::ffff:127.0.0.1]:80"}) {
        const auto address = listenAddress(text);
        ASSERT_TRUE(address) << text;
        EXPECT_FALSE(address->loopback) << text;
    }
}

TEST(ListenAddress, AllElseIsNone) {
    for (const char* text : {"",
                             ":",
                             "8787",
                             "127.0.0.1",
                             "127.0.0.1:",
                             ":8787",
                             "127.0.0.1:65536",
                             "127.0.0.1:-1",
                             "127.0.0.1:+1",
                             "127.0.0.1: 1",
                             "127.0.0.1:1x",
                             "127.1:80",
                             "127.0.0.256:80",
                             "::1:80",
                             "[::1]",
                             "[::1:80",
                             "[]:80",
                             "[127.0.0.1]:80",
                             "localhost:80",
                             " 127.0.0.1:80"})
        EXPECT_FALSE(listenAddress(text)) << text;
}

} // namespace
} // namespace autostereo::config
