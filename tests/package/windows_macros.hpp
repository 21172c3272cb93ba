// SPDX-License-Identifier: MIT
// Macros of <windows.h> and similar headers, for a test that our public headers compile after it. GCC's own headers
// come first: its standard library does not compile after min and max.
#pragma once

#if __has_include(<bits/stdc++.h>)
#include <bits/stdc++.h>
#endif

#define near
#define far
#define NEAR near
#define FAR far
#define small char
#define hyper long
#define interface struct
#define IN
#define OUT
#define OPTIONAL
#define ERROR 0
#define CONST const
#define VOID void
#define DELETE 1
#define STRICT 1
#define TRUE 1
#define FALSE 0
#define DOMAIN 1
#define OVERFLOW 3
#define UNDERFLOW 4
#define INFINITE 0xFFFFFFFF
#define ABSOLUTE 1
#define RELATIVE 2
#define pascal
#define cdecl
#define rad1 0x0420
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
