// What mip.cpp needs of the run-time library of Kaitai Struct for C++, which no registry of packages has.
#pragma once
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#define KAITAI_STRUCT_VERSION 11000L

namespace kaitai {

class kstream {
  public:
    explicit kstream(const std::string &data) : data_(data) {
    }
    bool is_eof() const {
        return at_ >= data_.size() && bits_ == 0;
    }
    uint64_t pos() const {
        return at_;
    }
    uint64_t size() const {
        return data_.size();
    }
    void seek(uint64_t to) {
        at_ = to;
        align_to_byte();
    }
    void align_to_byte() {
        bits_ = 0;
    }
    int8_t read_s1() {
        return static_cast<int8_t>(number(1));
    }
    int16_t read_s2be() {
        return static_cast<int16_t>(number(2));
    }
    int64_t read_s8be() {
        return static_cast<int64_t>(number(8));
    }
    int32_t read_s4be() {
        return static_cast<int32_t>(number(4));
    }
    uint8_t read_u1() {
        return static_cast<uint8_t>(number(1));
    }
    uint16_t read_u2be() {
        return static_cast<uint16_t>(number(2));
    }
    uint32_t read_u4be() {
        return static_cast<uint32_t>(number(4));
    }
    uint64_t read_u8be() {
        return number(8);
    }
    float read_f4be() {
        return as<float>(read_u4be());
    }
    double read_f8be() {
        return as<double>(read_u8be());
    }
    std::string read_bytes(uint64_t count) {
        align_to_byte();
        need(count);
        at_ += count;
        return data_.substr(at_ - count, count);
    }
    std::string read_bytes_full() {
        return read_bytes(data_.size() - at_);
    }
    std::string read_bytes_term(char end, bool include, bool consume, bool) {
        size_t found = data_.find(end, at_);
        if (found == std::string::npos) {
            return read_bytes_full();
        }
        std::string before = read_bytes(found - at_ + include);
        at_ += consume && !include;
        return before;
    }
    uint64_t read_bits_int_be(int count) {
        uint64_t value = 0;
        for (; count > 0; --count) {
            value = value << 1 | bit(true);
        }
        return value;
    }
    uint64_t read_bits_int_le(int count) {
        uint64_t value = 0;
        for (int i = 0; i < count; ++i) {
            value |= static_cast<uint64_t>(bit(false)) << i;
        }
        return value;
    }
    static std::string bytes_to_str(const std::string &bytes, const char *) {
        return bytes;
    }

  private:
    std::string data_;
    uint64_t at_ = 0;
    int bits_ = 0; // of the byte before `at_` that have not been read

    void need(uint64_t count) const {
        if (at_ > data_.size() || count > data_.size() - at_) {
            throw std::out_of_range("end of the data");
        }
    }
    uint64_t number(int count) {
        align_to_byte();
        need(count);
        uint64_t value = 0;
        for (; count > 0; --count) {
            value = value << 8 | static_cast<uint8_t>(data_[at_++]);
        }
        return value;
    }
    bool bit(bool first_is_highest) {
        if (bits_ == 0) {
            need(1);
            ++at_;
            bits_ = 8;
        }
        --bits_;
        return static_cast<uint8_t>(data_[at_ - 1]) >> (first_is_highest ? bits_ : 7 - bits_) & 1;
    }
    template <class To, class From>
    static To as(From from) {
        To to;
        static_assert(sizeof(to) == sizeof(from), "");
        std::memcpy(&to, &from, sizeof(to));
        return to;
    }
};

class kstruct {
  public:
    explicit kstruct(kstream *io) : m__io(io) {
    }
    virtual ~kstruct() {
    }
    kstream *_io() const {
        return m__io;
    }

  protected:
    kstream *m__io;
};

} // namespace kaitai
