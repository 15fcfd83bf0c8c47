// SPDX-License-Identifier: BSD-3-Clause
// A non-owning reference to a callable: two words, no allocation. It must not outlive the callable.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace boxplus::detail {

template <class T, class U>
concept OtherThan = !std::is_same_v<std::remove_cvref_t<T>, U>;

template <class Signature>
class FunctionRef;

template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
 public:
  template <OtherThan<FunctionRef> Callable>
  // NOLINTNEXTLINE(google-explicit-constructor): implicit, like a reference
  FunctionRef(Callable&& callable) noexcept
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
        call_([](void* object, Arguments... arguments) -> Result {
          return (*static_cast<std::remove_reference_t<Callable>*>(object))(
              std::forward<Arguments>(arguments)...);
        }) {}

  Result operator()(Arguments... arguments) const {
    return call_(object_, std::forward<Arguments>(arguments)...);
  }

 private:
  void* object_;
  Result (*call_)(void*, Arguments...);
};

}  // namespace boxplus::detail
