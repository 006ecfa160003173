// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/language.hpp"

namespace hardball {

/// What a class befriends so that archives can restore it.
///
/// A class that can be archived has `static void persist(auto& archive, auto& self)`, which names its state
/// once, for writing and for reading: archive(self.a_, self.b_). It may call archive.require(condition) on
/// what it has read, and ask archive.version() where the format has changed. It needs a default constructor,
/// private if need be, for objects that are about to be read; and it may have `bool restored()`, called when
/// its state has been read, which derives what is not archived and returns false if no such object has that
/// state.
class Persistence {
 public:
  template <class T>
  static T blank() {
    return T();
  }

  template <class Archive, class T>
  static void persist(Archive& archive, T& object) {
    T::persist(archive, object);
  }
  template <class Archive, class T>
  static void persist(Archive& archive, const T& object) {
    T::persist(archive, object);
  }

  template <class T>
  static bool restored(T& object) {
    if constexpr (requires { object.restored(); }) return object.restored();
    return true;
  }
};

}  // namespace hardball
