#pragma once

#include "model/formats/brushes/brush_file.h"

#include <QHash>
#include <QObject>

namespace suffuse {

class Editor;

/// All brushes that can be chosen: the built-in ones and the user's, which are files in one folder; and which of them
/// are favourites. One for all windows.
class BrushLibrary : public QObject {
    Q_OBJECT

public:
    static constexpr int keys = 9; ///< so many favourites have a key

    /// That of the program: the user's data folder.
    static BrushLibrary &instance();
    /// Brushes of another folder; files that cannot be read are left out.
    explicit BrushLibrary(const QString &folder, QObject *parent = nullptr);

    /// Built-in ones first, then the user's by name.
    const std::vector<Brush> &brushes() const { return m_brushes; }
    const Brush *find(const QString &name) const; ///< null if there is none
    bool isOwn(const QString &name) const { return m_files.contains(name); }

    /// Adds one under its name, or the name with a number where that is taken. Returns the name it got.
    Result<QString> add(Brush brush);
    /// Replaces the user's brush of that name.
    Result<void> save(const Brush &brush);
    Result<void> rename(const QString &name, const QString &to);
    Result<void> remove(const QString &name);
    /// A brush file or a MyPaint brush; `left` gets what of it does not map. Returns its name.
    Result<QString> import(const QString &path, QStringList *left = nullptr);
    Result<void> exportTo(const QString &name, const QString &path) const;

    /// In the order in which they were made favourites: the first has the key 1. Names that are gone are left out.
    QStringList favourites() const;
    bool isFavourite(const QString &name) const { return favourites().contains(name); }
    void setFavourite(const QString &name, bool favourite);

    /// Takes a brush into the editor's hand; red, yellow and blue of the current colour stay.
    void use(Editor &editor, const QString &name) const;

signals:
    void changed();

private:
    void readFolder();
    void sort();
    void erase(const QString &name);
    QString freeName(const QString &wanted) const;

    QString m_folder;
    std::vector<Brush> m_brushes;
    QHash<QString, QString> m_files; ///< of the user's brushes, by name
};

/// Equal but for red, yellow and blue, which belong to the hand.
bool isSameBrush(const Brush &a, const Brush &b);
/// A brush's name for people: translated for built-in ones.
QString brushTitle(const QString &name);
/// A group's name for people.
QString brushGroupTitle(const QString &group);

} // namespace suffuse
