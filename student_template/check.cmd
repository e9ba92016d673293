@echo off
rem check [--quick]: what ./check does elsewhere; it is written in cmake\check.cmake.
setlocal
cd /d "%~dp0"
chcp 65001 >nul
cmake --version >nul 2>nul
if errorlevel 1 (
  echo cmake is missing; README.md says how to install it
  exit /b 2
)
rem Without blocks, which a bracket in an argument would end.
if not exist build mkdir build
>build\check-status echo 2
if "%~1"=="--view" cmake -P cmake/check.cmake -- --build
set /p status=<build\check-status
if "%~1"=="--view" if not exist build\release\program exit /b %status%
if "%~1"=="--view" for /f %%p in (build\release\program) do if not exist build\%%p.exe exit /b %status%
if "%~1"=="--view" for /f %%p in (build\release\program) do build\%%p.exe %*
if "%~1"=="--view" exit /b
rem CMake's children write to pipes: only this script sees whether somebody looks on.
if exist build\build_bar.exe build\build_bar && set CHECK_TERMINAL=1
cmake -P cmake/check.cmake -- %*
set /p status=<build\check-status
exit /b %status%
