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

/// The one store: the user's settings file, or the INI file that the environment variable SUFFUSE_SETTINGS names (for
/// tests). A file that cannot be read counts as empty; one that no Suffuse can have written is put aside as
/// "….damaged".
QSettings &store();
/// Alters a list that other running instances alter, too: `change` gets what is stored now, or `usual` where nothing is,
/// and what it returns is stored before any of them can alter it.
void updateList(const QString &key, const std::function<QStringList(const QStringList &stored)> &change,
                const QStringList &usual = {});
/// From now on the store is empty at first and forgotten at the end (`--safe-mode`).
void forgetEverything();
/// Call it before anything is read. After two starts in a row that never showed a window, the settings are put aside.
/// Returns where they are then, else an empty string.
QString beginStart();
/// The window is there: the next start need not fear the settings.
void startSucceeded();

enum class Theme { System, Dark, Light };
enum class Presenter { Auto, Raster, OpenGL };

/// "" (the system's), "en", "zh_CN" or "de"; anything else that a file holds counts as "".
QString language();
void setLanguage(const QString &code);
Theme theme();
void setTheme(Theme theme);
/// The environment variable SUFFUSE_PRESENTER is not looked at here.
Presenter presenter();
void setPresenter(Presenter presenter);
/// Auto, Cpu or Cuda. The environment variable SUFFUSE_BACKEND is not looked at here.
Backend backend();
void setBackend(Backend backend);
/// Threads for rendering, 0: all cores; at most 256.
int threads();
void setThreads(int count);

/// Whether spread and density follow the shape when strokes are scaled.
bool scalesSpread();
void setScalesSpread(bool scales);
/// Snapping and grid, of the window that changed them last. A grid step out of range counts as unset.
CanvasAids canvasAids();
void setCanvasAids(const CanvasAids &aids);

/// A curve that cannot be read counts as unset.
PenSettings penSettings();
void setPenSettings(const PenSettings &pen);

/// The brush that was in hand last; the first built-in one where none that can be read is stored.
Brush brush();
void setBrush(const Brush &brush);

/// Earlier versions that are kept beside a file that is saved, 0 to mostBackups (model/formats/atomic_save.h); 2 unless
/// something else was chosen.
int backups();
void setBackups(int count);

/// Absolute paths, the newest first, at most 10; files that are gone are left out, and so are other names of one file.
/// All running instances have the same list.
QStringList recentFiles();
void addRecentFile(const QString &path);
void clearRecentFiles();

} // namespace suffuse::settings
