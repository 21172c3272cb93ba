// SPDX-License-Identifier: MIT
// A finger in C#, with the declarations of limitcurve.cs: dragged until it slips, turned, and on another material.
using System;
using System.Runtime.InteropServices;
using static LimitCurve;

static unsafe class DriveFinger {
  static void Check(Status status) {
    if (status != Status.Ok) throw new Exception(Marshal.PtrToStringAnsi(limitcurve_error()));
  }
  static void Expect(double got, double expected) {
    if (!(Math.Abs(got - expected) <= 1e-6 * Math.Abs(expected)))
      throw new Exception("got " + got + ", expected " + expected);
  }

  static void Main() {
    IntPtr law, table, finger, other;
    Check(limitcurve_law_parse("hertz", out law));
    var force = new double[1];
    var moment = new double[1];
    Check(limitcurve_law_evaluate(law, new[] {0.0}, (UIntPtr)1, force, moment, null, null));
    Expect(moment[0], 3 * Math.PI / 16);
    Check(limitcurve_table_build(law, 1e-8, out table));
    FingerParameters parameters = limitcurve_finger_defaults();
    parameters.mu = 0.6;
    parameters.stiffness = 1000;
    parameters.radiusLaw = Marshal.StringToCoTaskMemAnsi("constant:a=0.005");
    Check(limitcurve_finger_new(table, ref parameters, Projection.ClosestPoint, out finger));
    Check(limitcurve_finger_new(table, ref parameters, Projection.ClosestPoint, out other));
    Marshal.FreeCoTaskMem(parameters.radiusLaw);
    FingerOutput output = default(FingerOutput);
    Contact contact = default(Contact);
    contact.normal[2] = 1;
    contact.depth = 2e-3;
    for (int step = 0; step <= 10; ++step) {
      contact.point[0] = 1e-3 * step;
      Check(limitcurve_finger_update(finger, ref contact, 1e-3, out output));
      if (output.state != (step < 2 ? State.Stick : State.Slip))
        throw new Exception("step " + step + ": " + output.state);
      Check(limitcurve_finger_update_under_load(finger, ref contact, 2, 1e-3, out output));
    }
    Expect(output.load, 2);
    Expect(output.force[0], -0.6 * 2);

    // The device's orientation in place of a twist; another finger asks first what it will feel.
    Check(limitcurve_finger_reset(finger));
    for (int step = 0; step <= 100; ++step) {
      var orientation = new[] {Math.Cos(0.01 * step), 0, 0, Math.Sin(0.01 * step)};
      FingerOutput ahead;
      Check(limitcurve_finger_copy_state(finger, other));
      Check(limitcurve_finger_preview_pose(other, ref contact, orientation, 1e-3, out ahead));
      Check(limitcurve_finger_update_pose(finger, ref contact, orientation, 1e-3, out output));
      if (ahead.moment != output.moment) throw new Exception("step " + step);
    }
    Expect(output.moment, -0.6 * 2 * 0.005 * 3 * Math.PI / 16);
    double energy, margin, hold;
    Check(limitcurve_finger_spring_energy(finger, out energy));
    Expect(energy, 2e-3 + 0.5 * output.moment * output.moment / parameters.twistStiffness);
    parameters.mu = 0.3;
    parameters.radiusLaw = IntPtr.Zero;
    Check(limitcurve_finger_change(finger, ref parameters));
    Check(limitcurve_finger_margin(finger, out margin, out hold));
    Expect(hold, 4);
    limitcurve_finger_free(other);
    limitcurve_finger_free(finger);
    limitcurve_table_free(table);
    limitcurve_law_free(law);
  }
}
