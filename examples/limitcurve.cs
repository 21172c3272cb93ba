// SPDX-License-Identifier: MIT
// Declarations of c/limitcurve.h for C#: a law, a table, a finger and its loop. The structs are plain C structs. On
// 32-bit Windows each needs CallingConvention.Cdecl.
using System;
using System.Runtime.InteropServices;

enum Status { Ok = 0, Failed = 1, Invalid = 2 }
enum Projection { Radial = 0, CCurve = 1, ClosestPoint = 2 }
enum State { Free = 0, Stick = 1, Slip = 2, Invalid = 3 }

[StructLayout(LayoutKind.Sequential)]
struct FingerParameters {
  public double mu, muDynamic;
  public IntPtr radiusLaw;  // Marshal.StringToCoTaskMemUTF8; read by the call only; NULL: as it was
  public double muR, gamma, muRDynamic, stiffness, twistStiffness;
  public double damping, twistDamping, restMargin, maxSpeed, faultDecay;
}

[StructLayout(LayoutKind.Sequential)]
unsafe struct Contact {
  public fixed double point[3];
  public fixed double normal[3];
  public double depth, twist;
  public int landed;
}

[StructLayout(LayoutKind.Sequential)]
unsafe struct FingerOutput {
  public fixed double proxy[3];
  public double angle, depth;
  public fixed double normal[3];
  public double load;
  public fixed double force[3];
  public double moment, cor, slipWork;
  public State state;
  public int converged;
  public int fault;
}

static unsafe class LimitCurve {
  const string Library = "limitcurve-c";
  [DllImport(Library)] public static extern IntPtr limitcurve_error();  // Marshal.PtrToStringUTF8
  [DllImport(Library)] public static extern Status limitcurve_law_parse(
    [MarshalAs(UnmanagedType.LPUTF8Str)] string text, out IntPtr law);
  [DllImport(Library)] public static extern void limitcurve_law_free(IntPtr law);
  [DllImport(Library)] public static extern Status limitcurve_law_evaluate(IntPtr law, double[] cors, UIntPtr count,
    [Out] double[] forces, [Out] double[] moments, [Out] double[] forceErrors, [Out] double[] momentErrors);
  [DllImport(Library)] public static extern Status limitcurve_table_build(IntPtr law, double tolerance,
    out IntPtr table);
  [DllImport(Library)] public static extern void limitcurve_table_free(IntPtr table);
  [DllImport(Library)] public static extern FingerParameters limitcurve_finger_defaults();
  [DllImport(Library)] public static extern Status limitcurve_finger_new(IntPtr table, ref FingerParameters parameters,
    Projection projection, out IntPtr finger);
  [DllImport(Library)] public static extern Status limitcurve_join(Contact[] contacts, UIntPtr count,
    out Contact joined);
  [DllImport(Library)] public static extern Status limitcurve_finger_update(IntPtr finger, ref Contact contact,
    double timeStep, out FingerOutput output);
  [DllImport(Library)] public static extern Status limitcurve_finger_update_pose(IntPtr finger, ref Contact contact,
    double[] orientation, double timeStep, out FingerOutput output);
  [DllImport(Library)] public static extern Status limitcurve_finger_update_under_load(IntPtr finger,
    ref Contact contact, double load, double timeStep, out FingerOutput output);
  [DllImport(Library)] public static extern Status limitcurve_finger_update_under_load_pose(IntPtr finger,
    ref Contact contact, double load, double[] orientation, double timeStep, out FingerOutput output);
  [DllImport(Library)] public static extern Status limitcurve_finger_preview(IntPtr finger, ref Contact contact,
    double timeStep, out FingerOutput output);
  [DllImport(Library)] public static extern Status limitcurve_finger_preview_pose(IntPtr finger, ref Contact contact,
    double[] orientation, double timeStep, out FingerOutput output);
  [DllImport(Library)] public static extern Status limitcurve_finger_change(IntPtr finger,
    ref FingerParameters parameters);
  [DllImport(Library)] public static extern Status limitcurve_finger_copy_state(IntPtr from, IntPtr to);
  [DllImport(Library)] public static extern Status limitcurve_finger_spring_energy(IntPtr finger,
    out double springEnergy);
  [DllImport(Library)] public static extern Status limitcurve_finger_margin(IntPtr finger, out double margin,
    out double loadToHold);
  [DllImport(Library)] public static extern Status limitcurve_finger_reset(IntPtr finger);
  [DllImport(Library)] public static extern void limitcurve_finger_free(IntPtr finger);
}
