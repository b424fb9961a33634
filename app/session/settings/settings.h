// What the program remembers between sessions.
#pragma once

#include "app/session/selecting/snapping.h"
#include "app/session/settings/pen_input.h"
#include "model/brush/brush.h"
#include "render/renderer.h"

#include <QSettings>
#include <QStringList>

#include <functional>

namespace suffuse::settings {

/// The store of all settings: the user's settings file, or the INI file that the environment variable SUFFUSE_SETTINGS
/// names (for tests). A file that cannot be read counts as empty. A file that no Suffuse can have written is put aside
/// as "….damaged".
QSettings &store();
/// Alters a list that other running instances alter, too. `change` gets the list as it is stored now, or `usual` where
/// none is stored. Its result is stored before any other instance can alter the list.
void updateList(const QString &key, const std::function<QStringList(const QStringList &stored)> &change,
                const QStringList &usual = {});
/// From now on the store is empty, and it is forgotten at the end (`--safe-mode`).
void forgetEverything();
/// Call it before any setting is read. After two starts in a row that never showed a window, the settings are put
/// aside; then their new path is returned, else an empty string.
QString beginStart();
/// Call it when the window is there: the next start need not put the settings aside.
void startSucceeded();

enum class Theme { System, Dark, Light };
enum class Presenter { Auto, Raster, OpenGL };

/// The language: "" (the system's) or the code of one of `languages()`. Anything else in the file counts as "".
QString language();
void setLanguage(const QString &code);
Theme theme();
void setTheme(Theme theme);
/// The setting alone: the environment variable SUFFUSE_PRESENTER is not looked at here.
Presenter presenter();
void setPresenter(Presenter presenter);
/// Auto, Cpu or Cuda. This is the setting alone: the environment variable SUFFUSE_BACKEND is not looked at here.
Backend backend();
void setBackend(Backend backend);
/// The number of threads for rendering, at most 256; 0 means all cores.
int threads();
void setThreads(int count);

/// Whether spread and density follow the shape when strokes are scaled.
bool scalesSpread();
void setScalesSpread(bool scales);
/// Snapping and grid of the window that changed them last. A grid step out of range counts as unset.
CanvasAids canvasAids();
void setCanvasAids(const CanvasAids &aids);

/// The pen's settings. A curve that cannot be read counts as unset.
PenSettings penSettings();
void setPenSettings(const PenSettings &pen);

/// Whether a stroke was ever selected with a tool: until then the brush says how.
bool hasSelected();
void setHasSelected();

/// The brush that was in hand last, or `firstBrush` where no readable brush is stored.
Brush brush();
void setBrush(const Brush &brush);

/// How many earlier versions are kept beside a file that is saved: 0 to mostBackups (model/formats/atomic_save.h), and
/// 2 unless something else was chosen.
int backups();
void setBackups(int count);

/// The files that were opened or saved last: absolute paths, the newest first, at most 10. Files that are gone and
/// further names of one file are left out. All running instances share the list.
QStringList recentFiles();
void addRecentFile(const QString &path);
void clearRecentFiles();

} // namespace suffuse::settings
