// SPDX-License-Identifier: MIT
#pragma once

#include "c/limitcurve.h"

/// A handle of the C interface that is freed at the end of its scope: what a function makes goes to `made()`.
template <class Thing, void (*free)(Thing*)>
class Handle {
 public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { free(thing_); }
  operator Thing*() const { return thing_; }
  Thing** made() { return &thing_; }

 private:
  Thing* thing_ = nullptr;
};
using LawHandle = Handle<limitcurve_law, limitcurve_law_free>;
using TableHandle = Handle<limitcurve_table, limitcurve_table_free>;
using PatchHandle = Handle<limitcurve_patch, limitcurve_patch_free>;
using FingerHandle = Handle<limitcurve_finger, limitcurve_finger_free>;
using BatchHandle = Handle<limitcurve_batch, limitcurve_batch_free>;
