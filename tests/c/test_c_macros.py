"""Headers compile behind the macros that platforms define: Arduino, Windows, macOS, X11, Linux, C libraries."""

from __future__ import annotations

from pathlib import Path

import pytest
from c_build import folder, include, run
from support import need, uses

#: Names that platforms define as macros with arguments.
FUNCTIONS = """abs bit bitClear bitRead bitSet bitWrite check check_noerr constrain container_of degrees highByte
    interrupts isfinite isinf isnan likely lowByte major makedev map max min minor noInterrupts radians require
    require_noerr round signbit sq str swap unlikely verify xstr T_ N_ ARRAY_SIZE BIT BIT_MASK CONTAINER_OF F LOG
    UNUSED RGB MIN MAX ALIGN ASSERT SWAP"""
#: Names that they define as macros without arguments.
OBJECTS = """far i386 interface linux near nil pascal small st_atime sun unix ADC1 Above ALWAYS API Always B0 B1 Below
    BITS BOOL BUFSIZ BUSY Bool CHANGE CLOCK CONST DEBUG DEFAULT DEG_TO_RAD DELETE DISABLE DISPLAY DMA DOMAIN ENABLE EOF
    ERROR EXPORT EXTERNAL FAIL FALLING FALSE FATAL GPIO GPIOA HIGH HUGE_VAL I IDLE IN INFINITY INFO INLINE INPUT
    INTERNAL IO LOW MASK M_E M_PI NAN NIL NO NO_ERROR NONE Never None OK OPTIONAL OUT OUTPUT OVERFLOW PACKED PASS PI
    PLOSS PORTA PORTB RAD_TO_DEG READ READY RESET RISING RTC SERIAL SET SHIFT SING SPI1 STATIC STRICT Status Success
    THIS TIM1 TIMEOUT TLOSS TRACE TRUE UART UNDERFLOW USART1 Unsorted VOID WARN WDT WRITE YES GetMessage SendMessage
    GetObject DrawText GetCurrentTime Yield _A _B _C _L _N _P _S _U _X _Y"""


@pytest.mark.parametrize(
    ("compiler", "header"), [("cc", "mip.h"), pytest.param("g++", "cpp/mip.hpp", marks=uses("g++"))]
)
def test_headers_do_not_use_names_of_macros(compiler: str, header: str, tmp_path: Path) -> None:
    functions, objects = FUNCTIONS.split(), OBJECTS.split()
    assert len(functions) + len(objects) >= 130
    needed = "iterator new optional ostream string_view type_traits"
    needed = "string stdbool stddef stdint" if header == "mip.h" else needed
    text = "".join(f"#include <{name}{'.h' if header == 'mip.h' else ''}>\n" for name in needed.split())
    text += "".join(f"#undef {name}\n#define {name}(...) @ {name}\n" for name in functions)
    text += "".join(f"#undef {name}\n#define {name} @ {name}\n" for name in objects)
    program = tmp_path / ("program.c" if header == "mip.h" else "program.cpp")
    more = "line.h" if header == "mip.h" else "extra/ostream.hpp"
    program.write_text(f'{text}#include "mip/{header}"\n#include "mip/{more}"\nint unused;\n')
    assert (folder("real") / "src/mip" / header).exists()
    includes = (include("real"), f"-I{folder('real')}/ports")
    run(need(compiler), "-std=c99" if header == "mip.h" else "-std=c++17", *includes, "-fsyntax-only", program)
