#pragma once

#include "model/formats/brushes/brush_file.h"

#include <QHash>
#include <QObject>

namespace suffuse {

class Editor;

/// Holds all brushes that can be chosen: the built-in ones, and the user's, which are files in one folder. It also
/// knows which of them are favourites. All windows share one library.
class BrushLibrary : public QObject {
    Q_OBJECT

public:
    static constexpr int keys = 9; ///< the first so many favourites have a key

    /// The library of the program, of the user's data folder.
    static BrushLibrary &instance();
    /// A library of another folder. Files that cannot be read are left out.
    explicit BrushLibrary(const QString &folder, QObject *parent = nullptr);

    /// The built-in brushes first, then the user's by name.
    const std::vector<Brush> &brushes() const { return m_brushes; }
    const Brush *find(const QString &name) const; ///< null if there is none
    /// Whether a brush differs from the one of its name, if there is one.
    bool isChanged(const Brush &brush) const;
    bool isOwn(const QString &name) const { return m_files.contains(name); }

    /// Adds a brush under its name, or under the name with a number where the name is taken. Returns the name that it
    /// got.
    Result<QString> add(Brush brush);
    /// Replaces the user's brush of that name.
    Result<void> save(const Brush &brush);
    Result<void> rename(const QString &name, const QString &to);
    Result<void> remove(const QString &name);
    /// Imports a brush file or a MyPaint brush. `left` gets the settings that have no counterpart. Returns the brush's
    /// name.
    Result<QString> import(const QString &path, QStringList *left = nullptr);
    Result<void> exportTo(const QString &name, const QString &path) const;

    /// The favourites in the order in which they were chosen; the first has the key 1. Names of brushes that are gone
    /// are left out.
    QStringList favourites() const;
    bool isFavourite(const QString &name) const { return favourites().contains(name); }
    void setFavourite(const QString &name, bool favourite);

    /// Takes a brush into the editor's hand, as it was left there last. Changes of the brush that was in hand are kept
    /// until the program ends. Red, yellow and blue of the current colour stay.
    void use(Editor &editor, const QString &name);
    /// Takes a brush into the editor's hand as it is in the library, and forgets its changes.
    void reload(Editor &editor, const QString &name);
    /// Whether changes of a brush are kept that is not in hand.
    bool hasChanges(const QString &name) const { return m_left.contains(name); }
    /// Forgets the changes of a brush that is not in hand.
    void forgetChanges(const QString &name);

signals:
    void changed();
    /// Changes of a brush are kept, or forgotten.
    void changesKept(const QString &name);

private:
    static void take(Editor &editor, Brush brush);
    void readFolder();
    void sort();
    void erase(const QString &name);
    QString freeName(const QString &wanted) const;

    QString m_folder;
    std::vector<Brush> m_brushes;
    QHash<QString, QString> m_files; ///< files of the user's brushes, by name
    QHash<QString, Brush> m_left;    ///< brushes as they were left, by name; only those that differ from the library
};

/// Whether two brushes are equal except for red, yellow and blue, which belong to the hand.
bool isSameBrush(const Brush &a, const Brush &b);
/// A brush's name for people. Names of built-in brushes are translated.
QString brushTitle(const QString &name);
/// A group's name for people.
QString brushGroupTitle(const QString &group);
/// Whether a search finds a brush: by its name or its group's, as people see them or as files and the manual write them
/// ("flat-wash"). An empty text finds all.
bool isBrushCalled(const Brush &brush, const QString &typed);
/// How well a typed text suits the name of a brush that is called so: 0 is the best.
int searchRank(const Brush &brush, const QString &typed);

} // namespace suffuse
