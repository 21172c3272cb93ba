// SPDX-License-Identifier: MIT
// examples/limitcurve.cs at work: a law's wrench, and a finger that is dragged until it slips.
using System;
using System.Runtime.InteropServices;

static unsafe class DriveFinger {
  static void Check(Status status) {
    if (status != Status.Ok) throw new Exception(Marshal.PtrToStringAnsi(LimitCurve.limitcurve_error()));
  }
  static void Expect(double got, double expected) {
    if (!(Math.Abs(got - expected) <= 1e-6 * Math.Abs(expected))) throw new Exception("got " + got + ", expected " + expected);
  }

  static void Main() {
    IntPtr law, table, finger;
    Check(LimitCurve.limitcurve_law_parse("hertz", out law));
    var force = new double[1];
    var moment = new double[1];
    Check(LimitCurve.limitcurve_law_evaluate(law, new[] {0.0}, (UIntPtr)1, force, moment, null, null));
    Expect(moment[0], 3 * Math.PI / 16);
    Check(LimitCurve.limitcurve_table_build(law, 1e-8, out table));
    FingerParameters parameters = LimitCurve.limitcurve_finger_defaults();
    parameters.mu = 0.6;
    parameters.stiffness = 1000;
    parameters.radiusLaw = Marshal.StringToCoTaskMemAnsi("constant:a=0.005");
    Check(LimitCurve.limitcurve_finger_new(table, ref parameters, Projection.ClosestPoint, out finger));
    Marshal.FreeCoTaskMem(parameters.radiusLaw);
    FingerOutput output = default(FingerOutput);
    for (int step = 0; step <= 10; ++step) {
      Contact contact = default(Contact);
      contact.point[0] = 1e-3 * step;
      contact.normal[2] = 1;
      contact.depth = 2e-3;
      Check(LimitCurve.limitcurve_finger_update(finger, ref contact, 1e-3, out output));
      if (output.state != (step < 2 ? State.Stick : State.Slip)) throw new Exception("step " + step + ": " + output.state);
      Check(LimitCurve.limitcurve_finger_update_under_load(finger, ref contact, 2, 1e-3, out output));
    }
    Expect(output.load, 2);
    Expect(output.force[0], -0.6 * 2);
    LimitCurve.limitcurve_finger_free(finger);
    LimitCurve.limitcurve_table_free(table);
    LimitCurve.limitcurve_law_free(law);
  }
}
