// What mip.cpp needs of the run-time library of Kaitai Struct for C++, which no registry of packages has: declarations.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

#define KAITAI_STRUCT_VERSION 11000L

namespace kaitai {

class kstream {
  public:
    bool is_eof() const;
    uint64_t pos() const;
    uint64_t size() const;
    void seek(uint64_t to);
    void align_to_byte();
    int8_t read_s1();
    int16_t read_s2be();
    int32_t read_s4be();
    int64_t read_s8be();
    uint8_t read_u1();
    uint16_t read_u2be();
    uint32_t read_u4be();
    uint64_t read_u8be();
    float read_f4be();
    double read_f8be();
    std::string read_bytes(uint64_t count);
    std::string read_bytes_full();
    std::string read_bytes_term(char end, bool include, bool consume, bool must);
    uint64_t read_bits_int_be(int count);
    uint64_t read_bits_int_le(int count);
    explicit kstream(const std::string &data);
    static std::string bytes_to_str(const std::string &bytes, const char *encoding);
};

class kstruct {
  public:
    explicit kstruct(kstream *io);
    virtual ~kstruct();
    kstream *_io() const;

  protected:
    kstream *m__io;
};

} // namespace kaitai
