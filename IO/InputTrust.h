/**
 * InputTrust: lifts the limits that protect from harmful input files.
 */
#pragma once

namespace vfm
{

/// Trust in the input files that this thread opens during the lifetime of the object. Headers of
/// trusted files may name files outside of their folders. The length of lines and the compression
/// ratio are not limited.
class InputTrust
{
public:
  explicit InputTrust(bool isGiven) : Before(Current()) { Current() = isGiven; }
  ~InputTrust() { Current() = this->Before; }
  InputTrust(const InputTrust&) = delete;
  InputTrust& operator=(const InputTrust&) = delete;

  static bool IsGiven() { return Current(); }
  /// Advice for messages about a limit.
  static constexpr const char* Advice =
    "If you trust the file, use --trust-input (sculptor, vfmesh), TrustInput (ParaView) or "
    "trust_input=True (Python).";

private:
  static bool& Current()
  {
    static thread_local bool isGiven = false;
    return isGiven;
  }

  bool Before;
};

} // namespace vfm
