// SPDX-License-Identifier: MIT
// A finger in Rust that is dragged until it slips. The declarations are bindgen's of limitcurve.h:
//     bindgen limitcurve.h --allowlist-function 'limitcurve_.*' --allowlist-var 'LIMITCURVE_.*' -o limitcurve.rs
mod ffi {
    #![allow(non_upper_case_globals, non_camel_case_types, dead_code)]
    include!(concat!(env!("OUT_DIR"), "/limitcurve.rs"));
}
use ffi::*;
use std::ffi::{CStr, CString};
use std::ptr::null_mut;

fn check(status: limitcurve_status) -> Result<(), String> {
    if status == limitcurve_status_LIMITCURVE_OK {
        return Ok(());
    }
    Err(unsafe { CStr::from_ptr(limitcurve_error()) }.to_string_lossy().into_owned())
}

struct Finger(*mut limitcurve_finger);

impl Finger {
    fn new(law: &str, radius_law: &str, mut skin: limitcurve_finger_parameters) -> Result<Self, String> {
        let (law, radius_law) = (CString::new(law).unwrap(), CString::new(radius_law).unwrap());
        skin.radius_law = radius_law.as_ptr();
        let (mut made, mut table, mut finger) = (null_mut(), null_mut(), null_mut());
        unsafe {
            let result = check(limitcurve_law_parse(law.as_ptr(), &mut made))
                .and_then(|_| check(limitcurve_table_build(made, 1e-8, &mut table)))
                .and_then(|_| check(limitcurve_finger_new(table, &skin, LIMITCURVE_CLOSEST_POINT as limitcurve_projection, &mut finger)));
            limitcurve_table_free(table);
            limitcurve_law_free(made);
            result.map(|_| Finger(finger))
        }
    }
    fn update(&mut self, contact: &limitcurve_contact, orientation: &[f64; 4], time_step: f64) -> limitcurve_finger_output {
        unsafe {
            let mut out = std::mem::zeroed();
            limitcurve_finger_update_pose(self.0, contact, orientation.as_ptr(), time_step, &mut out);
            out
        }
    }
}

impl Drop for Finger {
    fn drop(&mut self) {
        unsafe { limitcurve_finger_free(self.0) }
    }
}

fn main() -> Result<(), String> {
    let skin = limitcurve_finger_parameters { mu: 0.6, ..unsafe { limitcurve_finger_defaults() } };
    let mut finger = Finger::new("hertz", "constant:a=0.006", skin)?;
    let mut contact = limitcurve_contact { point: [0.0; 3], normal: [0.0, 0.0, 1.0], depth: 0.002, twist: 0.0, landed: 0 };
    let mut out = finger.update(&contact, &[1.0, 0.0, 0.0, 0.0], 1e-3);
    for _ in 0..1000 {
        contact.point[0] += 2e-5;
        out = finger.update(&contact, &[1.0, 0.0, 0.0, 0.0], 1e-3);
    }
    println!("load {:.6} N, friction {:.6} N", out.load, out.force[0]);
    assert!(out.state == limitcurve_state_LIMITCURVE_SLIP && (out.force[0] / out.load + 0.6).abs() < 1e-6);
    let bad = limitcurve_finger_parameters { mu: -1.0, ..skin };
    assert!(Finger::new("hertz", "constant:a=0.006", bad).err().unwrap().starts_with("mu"));
    Ok(())
}
