#include <boost/crc.hpp>

#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/time/checkpoint.h>

#include <cstdlib>
#include <cstring>
#include <new>

using namespace RollingContact;

/** A forged size asks for more than there is: on a machine without ASan that
 * is std::bad_alloc. */
void *operator new(const std::size_t n)
{
  void *const memory = n < (1u << 26) ? std::malloc(n) : nullptr;
  if (memory == nullptr)
    throw std::bad_alloc();
  return memory;
}

void operator delete(void *const memory) noexcept
{
  std::free(memory);
}

void operator delete(void *const memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace
{
  /** The head write_checkpoint() puts before an archive. */
  std::string head_of(const std::string &archive)
  {
    char                head[40] = "rolling-contact restart";
    const std::uint64_t n_bytes  = archive.size();
    boost::crc_32_type  crc;
    crc.process_bytes(archive.data(), archive.size());
    const std::uint32_t version = 1, checksum = crc.checksum();
    std::memcpy(head + 24, &version, 4);
    std::memcpy(head + 28, &checksum, 4);
    std::memcpy(head + 32, &n_bytes, 8);
    return {head, sizeof(head)};
  }
} // namespace

/** As it stands, then behind a head that belongs to it. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const RunFolder   folder("", "", "");
  const std::string bytes(reinterpret_cast<const char *>(data), size);
  for (const std::string &file : {bytes, head_of(bytes) + bytes})
    try
      {
        write_part(checkpoint_name, {file}, 0);
        read_checkpoint(folder);
      }
    catch (const InputError &)
      {}
  return 0;
}
