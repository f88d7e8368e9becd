<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>Actions</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Datensatz oder Modell öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>&amp;Bild speichern …</translation>
    </message>
    <message>
        <source>Save the view as a PNG picture</source>
        <translation>Speichert die Ansicht als PNG-Bild</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>Quit TAn</source>
        <translation>Beendet TAn</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig:</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen:</translation>
    </message>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Add an isosurface at another value</source>
        <translation>Fügt eine Isofläche bei einem weiteren Wert hinzu</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>&amp;Ecke</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Blick von dieser Seite</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show the whole domain</source>
        <translation>Zeigt das ganze Gebiet</translation>
    </message>
    <message>
        <source>&amp;Look From</source>
        <translation>&amp;Blick von</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Perspective, or parallel projection</source>
        <translation>Perspektive oder Parallelprojektion</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>&amp;Felder</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>&amp;Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the default layout</source>
        <translation>Stellt die ursprüngliche Anordnung wieder her</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Nutzt den ganzen Bildschirm</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Plugins…</source>
        <translation>&amp;Plugins …</translation>
    </message>
    <message>
        <source>The plugins that were found</source>
        <translation>Die gefundenen Plugins</translation>
    </message>
    <message>
        <source>&amp;About TAn</source>
        <translation>Ü&amp;ber TAn</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Save &amp;Mesh…</source>
        <translation>&amp;Netz speichern …</translation>
    </message>
    <message>
        <source>Save the mesh shown, for VTK, ParaView and others</source>
        <translation>Speichert das gezeigte Netz, für VTK, ParaView und andere</translation>
    </message>
    <message>
        <source>Save the isosurfaces shown, for 3D printers, Blender, ParaView and others</source>
        <translation>Speichert die gezeigten Isoflächen, für 3D-Drucker, Blender, ParaView und andere</translation>
    </message>
    <message>
        <source>Save the mesh size at each accuracy as a table</source>
        <translation>Speichert die Netzgröße jeder Genauigkeit als Tabelle</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>Be&amp;reich</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Save Session</source>
        <translation>&amp;Sitzung speichern</translation>
    </message>
    <message>
        <source>Save what is open and its view, to continue later</source>
        <translation>Speichert, was offen ist, mit seiner Ansicht, um später weiterzuarbeiten</translation>
    </message>
    <message>
        <source>Save Session &amp;As…</source>
        <translation>Sitzung speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the session in another file</source>
        <translation>Die Sitzung in einer anderen Datei speichern</translation>
    </message>
    <message>
        <source>Import with Op&amp;tions…</source>
        <translation>Mit &amp;Optionen importieren …</translation>
    </message>
    <message>
        <source>Open a part of a dataset, or choose how its file is read</source>
        <translation>Öffnet einen Teil eines Datensatzes oder legt fest, wie seine Datei gelesen wird</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Ha&amp;ndbuch</translation>
    </message>
    <message>
        <source>Open the manual in the browser</source>
        <translation>Öffnet das Handbuch im Webbrowser</translation>
    </message>
    <message>
        <source>Save S&amp;urfaces…</source>
        <translation>F&amp;lächen speichern …</translation>
    </message>
    <message>
        <source>Save Stat&amp;istics…</source>
        <translation>S&amp;tatistik speichern …</translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation>Be&amp;fehl suchen …</translation>
    </message>
    <message>
        <source>Search all commands</source>
        <translation>Durchsucht alle Befehle</translation>
    </message>
    <message>
        <source>Reduced &amp;Motion</source>
        <translation>&amp;Weniger Bewegung</translation>
    </message>
    <message>
        <source>Disable camera animation</source>
        <translation>Schaltet Kamerafahrten zwischen Ansichten aus</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help on This Control</source>
        <translation>&amp;Hilfe zu diesem Feld</translation>
    </message>
    <message>
        <source>Explain the focused control</source>
        <translation>Erklärt das Bedienelement, das den Fokus hat</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Click on a control to read what it does</source>
        <translation>Auf ein Bedienfeld klicken, um zu lesen, was es tut</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Es gibt nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Es gibt nichts zu wiederholen</translation>
    </message>
    <message>
        <source>Save &amp;Film…</source>
        <translation>Fil&amp;m speichern …</translation>
    </message>
    <message>
        <source>Save the animation as pictures or a video</source>
        <translation>Die Animation als Bilder oder als Video speichern</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the view to the clipboard</source>
        <translation>Kopiert die Ansicht in die Zwischenablage</translation>
    </message>
    <message>
        <source>&amp;Annotations</source>
        <translation>Beschr&amp;iftung</translation>
    </message>
    <message>
        <source>Picked &amp;Value</source>
        <translation>&amp;Gewählter Wert</translation>
    </message>
    <message>
        <source>Close the model and its dataset</source>
        <translation>Schließt das Modell und seinen Datensatz</translation>
    </message>
    <message>
        <source>Reset &amp;View</source>
        <translation>A&amp;nsicht zurücksetzen</translation>
    </message>
    <message>
        <source>Go back to the default accuracy, colours, isovalues and camera</source>
        <translation>Stellt die anfängliche Genauigkeit, Farben, Isowerte und Kamera wieder her</translation>
    </message>
    <message>
        <source>There is nothing to close</source>
        <translation>Es ist nichts zu schließen</translation>
    </message>
    <message>
        <source>Open Samp&amp;le</source>
        <translation>Beis&amp;piel öffnen</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>Aus&amp;richtung</translation>
    </message>
</context>
<context>
    <name>Annotations</name>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>%1 units at the target</source>
        <translation>%1 Einheiten am Blickziel</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 Einheiten</translation>
    </message>
    <message>
        <source>Colour &amp;bar</source>
        <translation>Far&amp;bskala</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;chsen</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>Maß&amp;stab</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>A&amp;ccuracy</source>
        <translation>Gena&amp;uigkeit</translation>
    </message>
    <message>
        <source>Values and their colours, in the units of the data; right their opacity, with marks at the isovalues</source>
        <translation>Werte und ihre Farben, in den Einheiten der Daten; rechts ihre Deckkraft, mit Marken an den Isowerten</translation>
    </message>
    <message>
        <source>The directions of x, y and z</source>
        <translation>Die Richtungen von x, y und z</translation>
    </message>
    <message>
        <source>A length in the units of the data; in perspective that of things as far away as the target</source>
        <translation>Eine Länge in den Einheiten der Daten; in der Perspektive die von Dingen in der Entfernung des Blickziels</translation>
    </message>
    <message>
        <source>The name of the model</source>
        <translation>Der Name des Modells</translation>
    </message>
    <message>
        <source>The error that what is shown keeps, in % of the value range</source>
        <translation>Der Fehler, den das Gezeigte einhält, in % des Wertebereichs</translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>%1 Up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>%1 Down</source>
        <translation>%1 nach unten</translation>
    </message>
</context>
<context>
    <name>ChangeView</name>
    <message>
        <source>Add Isovalue</source>
        <translation>Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Change Animation</source>
        <translation>Animation ändern</translation>
    </message>
    <message>
        <source>Change Annotations</source>
        <translation>Beschriftung ändern</translation>
    </message>
    <message>
        <source>Change Isovalue</source>
        <translation>Isowert ändern</translation>
    </message>
    <message>
        <source>Change Rendering Mode</source>
        <translation>Darstellungsart ändern</translation>
    </message>
    <message>
        <source>Change Transfer Function</source>
        <translation>Transferfunktion ändern</translation>
    </message>
    <message>
        <source>Change Rendering</source>
        <translation>Darstellung ändern</translation>
    </message>
    <message>
        <source>Change Focus</source>
        <translation>Fokus ändern</translation>
    </message>
    <message>
        <source>Change Window</source>
        <translation>Fenster ändern</translation>
    </message>
    <message>
        <source>Change Values</source>
        <translation>Werte ändern</translation>
    </message>
    <message>
        <source>Change Budget</source>
        <translation>Budget ändern</translation>
    </message>
    <message>
        <source>Change Accuracy</source>
        <translation>Genauigkeit ändern</translation>
    </message>
    <message>
        <source>Change Background</source>
        <translation>Hintergrund ändern</translation>
    </message>
    <message>
        <source>Move Camera</source>
        <translation>Kamera bewegen</translation>
    </message>
    <message>
        <source>Remove Isovalue</source>
        <translation>Isowert entfernen</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>There is no display for the window: neither DISPLAY nor WAYLAND_DISPLAY is set. “tan render” draws pictures into files instead; “tan --help” says what else works without a window.</source>
        <translation>Es gibt keinen Bildschirm für das Fenster: Weder DISPLAY noch WAYLAND_DISPLAY ist gesetzt. „tan render“ zeichnet Bilder stattdessen in Dateien; „tan --help“ sagt, was sonst ohne Fenster geht.</translation>
    </message>
    <message>
        <source>Shows volume data at any accuracy.</source>
        <translation>Zeigt Volumendaten in jeder Genauigkeit.</translation>
    </message>
    <message>
        <source>What draws the picture: auto, cpu or gl.</source>
        <translation>Was das Bild zeichnet: auto, cpu oder gl.</translation>
    </message>
    <message>
        <source>A dataset, a .tan model or a session to open.</source>
        <translation>Ein Datensatz, ein .tan-Modell oder eine Sitzung, die geöffnet werden.</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Build</source>
        <translation>Bauen</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isowerte</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transfer</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>A dataset is turned into a model once: a mesh of tetrahedra that can be had at any accuracy from then on. Choose a method and a file, and start.</source>
        <translation>Aus einem Datensatz wird einmal ein Modell: ein Netz aus Tetraedern, das es von da an in jeder Genauigkeit gibt. Ein Verfahren und eine Datei wählen und beginnen.</translation>
    </message>
    <message>
        <source>How far the mesh may deviate from the data, in percent of the range of values; or how many tetrahedra it may have. The curve shows what each error costs.</source>
        <translation>Wie weit das Netz von den Daten abweichen darf, in Prozent des Wertebereichs, oder wie viele Tetraeder es haben darf. Die Kurve zeigt, was jeder Fehler kostet.</translation>
    </message>
    <message>
        <source>Rendering mode and its settings: surfaces, volume or both.</source>
        <translation>Darstellungsart und ihre Einstellungen: Flächen, Volumen oder beides.</translation>
    </message>
    <message>
        <source>From where the model is seen, in numbers. In the picture: drag to turn, Shift and drag to move, the wheel zooms.</source>
        <translation>Von wo das Modell zu sehen ist, in Zahlen. Im Bild: Ziehen dreht, Ziehen mit Umschalt verschiebt, das Rad zoomt.</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>What each accuracy costs in vertices, tetrahedra, time and memory, and the mesh shown now in numbers.</source>
        <translation>Was jede Genauigkeit an Knoten, Tetraedern, Zeit und Speicher kostet, und das gezeigte Netz in Zahlen.</translation>
    </message>
    <message>
        <source>Surfaces on which the field has one value each, in the units of the data.</source>
        <translation>Flächen, auf denen das Feld je einen Wert hat, in den Einheiten der Daten.</translation>
    </message>
    <message>
        <source>The transfer function gives each value a colour and an opacity for the volume.</source>
        <translation>Die Transferfunktion gibt jedem Wert eine Farbe und eine Deckkraft für das Volumen.</translation>
    </message>
    <message>
        <source>A sphere or a box in which the mesh is more accurate than outside.</source>
        <translation>Eine Kugel oder ein Quader, in dem das Netz genauer ist als außerhalb.</translation>
    </message>
    <message>
        <source>Which part of the domain is shown at all: a box, and a range of values.</source>
        <translation>Welcher Teil des Gebiets überhaupt gezeigt wird: ein Quader und ein Bereich von Werten.</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Films of the model: a turntable, or a path through key frames that you choose.</source>
        <translation>Filme vom Modell: eine Runde um es herum oder ein Weg durch Schlüsselbilder, die Sie wählen.</translation>
    </message>
</context>
<context>
    <name>EditorPage</name>
    <message>
        <source>The editor cannot be used. %1</source>
        <translation>Der Editor kann nicht verwendet werden. %1</translation>
    </message>
    <message>
        <source>Help › Plugins lists all plugins and where they are looked for.</source>
        <translation>Hilfe › Plugins zeigt alle Plugins und wo nach ihnen gesucht wird.</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open a Dataset or a Model</source>
        <translation>Datensatz oder Modell öffnen</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save Mesh</source>
        <translation>Netz speichern</translation>
    </message>
    <message>
        <source>VTK XML unstructured grids (*.vtu)</source>
        <translation>Unstrukturierte Gitter, VTK-XML (*.vtu)</translation>
    </message>
    <message>
        <source>Boundary as VTK XML polydata (*.vtp)</source>
        <translation>Rand als Polydata, VTK-XML (*.vtp)</translation>
    </message>
    <message>
        <source>Boundary as STL (*.stl)</source>
        <translation>Rand als STL (*.stl)</translation>
    </message>
    <message>
        <source>Boundary as Wavefront OBJ (*.obj)</source>
        <translation>Rand als Wavefront-OBJ (*.obj)</translation>
    </message>
    <message>
        <source>Boundary as binary glTF (*.glb)</source>
        <translation>Rand als binäres glTF (*.glb)</translation>
    </message>
    <message>
        <source>Save Surfaces</source>
        <translation>Flächen speichern</translation>
    </message>
    <message>
        <source>STL files (*.stl)</source>
        <translation>STL-Dateien (*.stl)</translation>
    </message>
    <message>
        <source>Wavefront OBJ files (*.obj)</source>
        <translation>Wavefront-OBJ-Dateien (*.obj)</translation>
    </message>
    <message>
        <source>Binary glTF files (*.glb)</source>
        <translation>Binäre glTF-Dateien (*.glb)</translation>
    </message>
    <message>
        <source>VTK XML polydata (*.vtp)</source>
        <translation>Polydata, VTK-XML (*.vtp)</translation>
    </message>
    <message>
        <source>Save Statistics</source>
        <translation>Statistik speichern</translation>
    </message>
    <message>
        <source>Tables of comma-separated values (*.csv)</source>
        <translation>Tabellen, durch Kommas getrennt (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>VTK legacy files (*.vtk)</source>
        <translation>Ältere VTK-Dateien (*.vtk)</translation>
    </message>
    <message>
        <source>PLY files (*.ply)</source>
        <translation>PLY-Dateien (*.ply)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>HelpActions</name>
    <message>
        <source>Restart TAn to change the language.</source>
        <translation>Starten Sie TAn neu, um die Sprache zu wechseln.</translation>
    </message>
    <message>
        <source>&amp;As the System</source>
        <translation>&amp;Wie das System</translation>
    </message>
</context>
<context>
    <name>ImportForm</name>
    <message>
        <source>%1 (of the cells)</source>
        <translation>%1 (der Zellen)</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>%1: t = %2</source>
        <translation>%1: t = %2</translation>
    </message>
    <message>
        <source>All that fit together</source>
        <translation>Alle, die zusammenpassen</translation>
    </message>
    <message>
        <source>%1, %2 components</source>
        <translation>%1, %2 Komponenten</translation>
    </message>
</context>
<context>
    <name>ImportTexts</name>
    <message>
        <source>%1 = %2 bytes: the file has exactly that.</source>
        <translation>%1 = %2 Bytes: genau so viele hat die Datei.</translation>
    </message>
    <message>
        <source>All %1 = %2 points.</source>
        <translation>Alle %1 = %2 Punkte.</translation>
    </message>
    <message>
        <source>%1 = %2 of %3 points.</source>
        <translation>%1 = %2 von %3 Punkten.</translation>
    </message>
    <message>
        <source>The build takes about %1 of memory, %2 of disk and %3.</source>
        <translation>Der Bau braucht etwa %1 Arbeitsspeicher, %2 Plattenplatz und %3.</translation>
    </message>
    <message>
        <source>The build takes up to %1 of memory, %2 of disk and %3.</source>
        <translation>Der Bau braucht bis zu %1 Arbeitsspeicher, %2 Plattenplatz und %3.</translation>
    </message>
    <message>
        <source>This machine has %1 of memory.</source>
        <translation>Dieser Rechner hat %1 Arbeitsspeicher.</translation>
    </message>
    <message>
        <source>A volume needs at least two points along each axis. Take a larger region or a smaller stride.</source>
        <translation>Ein Volumen braucht mindestens zwei Punkte entlang jeder Achse. Nehmen Sie einen größeren Bereich oder eine kleinere Schrittweite.</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 = %2 bytes; the file has %3 (%4 missing).</source>
        <translation>%1 = %2 Bytes; die Datei hat %3 (%4 fehlen).</translation>
    </message>
    <message>
        <source>%1 = %2 bytes; the file has %3 (%4 too many).</source>
        <translation>%1 = %2 Bytes; die Datei hat %3 (%4 zu viel).</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>The manual is not installed. Install the package tan again with its documentation, or build TAn with the package python3-markdown; the same texts are in the folder docs of its sources.</source>
        <translation>Das Handbuch ist nicht installiert. Installieren Sie das Paket tan noch einmal mit seiner Dokumentation, oder bauen Sie TAn mit dem Paket python3-markdown; dieselben Texte liegen im Ordner docs der Quellen.</translation>
    </message>
    <message>
        <source>No program opens web pages here. Install a web browser, or read %1.</source>
        <translation>Hier öffnet kein Programm Webseiten. Installieren Sie einen Webbrowser, oder lesen Sie %1.</translation>
    </message>
</context>
<context>
    <name>MeshText</name>
    <message>
        <source>Limited by the budget of %1 tetrahedra.</source>
        <translation>Durch das Budget von %1 Tetraedern begrenzt.</translation>
    </message>
    <message>
        <source>Full resolution of the model.</source>
        <translation>Volle Auflösung des Modells.</translation>
    </message>
    <message>
        <source>The model contains no finer level.</source>
        <translation>Das Modell enthält keine feinere Stufe.</translation>
    </message>
    <message>
        <source>%1 of its %2 tetrahedra are shown.</source>
        <translation>%1 seiner %2 Tetraeder werden gezeigt.</translation>
    </message>
    <message>
        <source>error %1 in the focus, %2 outside</source>
        <translation>Fehler %1 im Fokus, %2 außerhalb</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>Shown: %1, and the same warping.</source>
        <translation>Gezeigt: %1, Verwerfung ebenso.</translation>
    </message>
    <message>
        <source>Shown: %1.</source>
        <translation>Gezeigt: %1.</translation>
    </message>
    <message>
        <source>%1 tetrahedra in %2 pieces, as the window cuts them</source>
        <translation>%1 Tetraeder in %2 Stücken, wie das Fenster sie schneidet</translation>
    </message>
</context>
<context>
    <name>NumberText</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Himmelblau</translation>
    </message>
    <message>
        <source>Bluish green</source>
        <translation>Blaugrün</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Zinnober</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Reddish purple</source>
        <translation>Purpur</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
</context>
<context>
    <name>PaletteCommands</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Not possible now</source>
        <translation>Jetzt nicht möglich</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
</context>
<context>
    <name>Plugin</name>
    <message>
        <source>Delaunay refinement</source>
        <translation>Delaunay-Verfeinerung</translation>
    </message>
    <message>
        <source>Starts from the corners and inserts the point of the largest error until the error is small enough.</source>
        <translation>Beginnt mit den Ecken und fügt jeweils den Punkt mit dem größten Fehler ein, bis der Fehler klein genug ist.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>The error at which to stop; 0 keeps everything, so that any accuracy can be shown later.</source>
        <translation>Der Fehler, bei dem aufgehört wird; 0 behält alles, sodass später jede Genauigkeit gezeigt werden kann.</translation>
    </message>
    <message>
        <source>% of the value range</source>
        <translation>% des Wertebereichs</translation>
    </message>
    <message>
        <source>Tables of points</source>
        <translation>Tabellen von Punkten</translation>
    </message>
    <message>
        <source>Reads scattered points with a value each from CSV, TSV and blank-separated text.</source>
        <translation>Liest verstreute Punkte mit je einem Wert aus CSV, TSV und durch Leerzeichen getrenntem Text.</translation>
    </message>
    <message>
        <source>CSV writer</source>
        <translation>CSV-Schreiber</translation>
    </message>
    <message>
        <source>Writes the points of any dataset as a table: x, y, z and value.</source>
        <translation>Schreibt die Punkte jedes Datensatzes als Tabelle: x, y, z und Wert.</translation>
    </message>
    <message>
        <source>Table of points (*.csv *.tsv *.xyz *.pts *.txt *.asc)</source>
        <translation>Tabelle von Punkten (*.csv *.tsv *.xyz *.pts *.txt *.asc)</translation>
    </message>
    <message>
        <source>Table of points (*.csv)</source>
        <translation>Tabelle von Punkten (*.csv)</translation>
    </message>
    <message>
        <source>Meshes of cells</source>
        <translation>Zellnetze</translation>
    </message>
    <message>
        <source>Reads meshes of tetrahedra, hexahedra, prisms and pyramids from VTK XML (.vtu) and AVS UCD (.inp).</source>
        <translation>Liest Netze aus Tetraedern, Hexaedern, Prismen und Pyramiden aus VTK-XML (.vtu) und AVS UCD (.inp).</translation>
    </message>
    <message>
        <source>VTU writer</source>
        <translation>VTU-Schreiber</translation>
    </message>
    <message>
        <source>Writes meshes of tetrahedra as VTK XML unstructured grids.</source>
        <translation>Schreibt Tetraedernetze als unstrukturierte Gitter in VTK-XML.</translation>
    </message>
    <message>
        <source>VTK unstructured grid (*.vtu)</source>
        <translation>Unstrukturiertes VTK-Gitter (*.vtu)</translation>
    </message>
    <message>
        <source>AVS UCD mesh (*.inp)</source>
        <translation>AVS-UCD-Netz (*.inp)</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>The array whose values to take, of points or of cells; nothing takes the one the file calls active, else the first.</source>
        <translation>Das Feld, dessen Werte genommen werden, von Punkten oder Zellen; ohne Angabe das, das die Datei aktiv nennt, sonst das erste.</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>Of arrays with several components: magnitude, or a number from 0.</source>
        <translation>Bei Feldern mit mehreren Komponenten: magnitude für den Betrag, oder eine Nummer ab 0.</translation>
    </message>
    <message>
        <source>Cutting the cells</source>
        <translation>Zerlegen der Zellen</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>Prüfen des Netzes</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Tables of points: the columns of x, y and z, by name or number, as in lon,lat,depth or 1,2,3; &apos;automatic&apos; takes those called x, y and z, else the first three.</source>
        <translation>Tabellen von Punkten: die Spalten für x, y und z, nach Name oder Nummer, wie lon,lat,depth oder 1,2,3; &apos;automatic&apos; nimmt die mit den Namen x, y und z, sonst die ersten drei.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>The values to take, by name or number; &apos;automatic&apos; takes the first there are.</source>
        <translation>Welche Werte genommen werden, nach Name oder Nummer; &apos;automatic&apos; nimmt die ersten.</translation>
    </message>
    <message>
        <source>Skip incomplete rows</source>
        <translation>Unvollständige Zeilen auslassen</translation>
    </message>
    <message>
        <source>Tables of points: leave out rows that lack a number, instead of refusing the file.</source>
        <translation>Tabellen von Punkten: Zeilen auslassen, denen eine Zahl fehlt, statt die Datei abzulehnen.</translation>
    </message>
    <message>
        <source>Scattered points: refinement fills their convex hull.</source>
        <translation>Verstreute Punkte: die Verfeinerung füllt ihre konvexe Hülle.</translation>
    </message>
    <message>
        <source>Finding the convex hull</source>
        <translation>Suche der konvexen Hülle</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Where accuracy matters: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach or value:q,reach, several separated by &apos;;&apos;. Errors there count in full, falling linearly to a tenth (or to &apos;,floor&apos; at the end) at the distance &apos;reach&apos;; the largest weight holds. Examples: &apos;point:16,16,8,10&apos;, &apos;value:120,15,0.05&apos;.</source>
        <translation>Wo Genauigkeit zählt: point:x,y,z,reichweite, box:x0,y0,z0,x1,y1,z1,reichweite oder value:q,reichweite, mehrere durch &apos;;&apos; getrennt. Fehler zählen dort voll und fallen linear auf ein Zehntel (oder auf den Wert eines letzten &apos;,boden&apos;) in der Entfernung &apos;reichweite&apos;; es gilt das größte Gewicht. Beispiele: &apos;point:16,16,8,10&apos;, &apos;value:120,15,0.05&apos;.</translation>
    </message>
    <message>
        <source>An irregular mesh: decimation keeps its shape and its cavities.</source>
        <translation>Ein unregelmäßiges Netz: Die Vergröberung erhält seine Form und seine Hohlräume.</translation>
    </message>
    <message>
        <source>A curvilinear grid: decimation takes fewer points for the same accuracy, but more time and memory.</source>
        <translation>Ein krummliniges Gitter: Die Vergröberung braucht für dieselbe Genauigkeit weniger Punkte, aber mehr Zeit und Speicher.</translation>
    </message>
    <message>
        <source>A regular lattice: decimation takes fewer points for the same accuracy, but more time and memory.</source>
        <translation>Ein regelmäßiges Gitter: Die Vergröberung braucht für dieselbe Genauigkeit weniger Punkte, aber mehr Zeit und Speicher.</translation>
    </message>
    <message>
        <source>A regular lattice: refinement keeps the exact domain and needs the least time.</source>
        <translation>Ein regelmäßiges Gitter: Die Verfeinerung erhält das Gebiet genau und braucht die wenigste Zeit.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Warping</source>
        <translation>Verwerfung</translation>
    </message>
    <message>
        <source>% of the diagonal</source>
        <translation>% der Diagonale</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>For curvilinear data: &apos;normalised&apos; takes the point that is farthest off in error or warping; &apos;paper&apos; compares the two in the units of the data, as the paper did, to compare with it. Both keep cells from turning over.</source>
        <translation>Bei krummlinigen Daten: „normalised“ nimmt den Punkt, der in Fehler oder Verwerfung am weitesten daneben liegt; „paper“ vergleicht beide in den Einheiten der Daten, wie der Aufsatz, zum Vergleich mit ihm. Beide bewahren Zellen vor dem Umklappen.</translation>
    </message>
    <message>
        <source>normalised</source>
        <translation>normiert</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>Aufsatz</translation>
    </message>
    <message>
        <source>A curvilinear grid: refinement in computational space bounds both error and warping.</source>
        <translation>Ein krummliniges Gitter: Die Verfeinerung im Rechenraum begrenzt Fehler und Verwerfung.</translation>
    </message>
    <message>
        <source>Distributing the points</source>
        <translation>Die Punkte werden verteilt</translation>
    </message>
    <message>
        <source>Refining</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Isosurfaces</source>
        <translation>Isoflächen</translation>
    </message>
    <message>
        <source>Shows the surfaces on which the field has the chosen values, each with a colour and an opacity.</source>
        <translation>Zeigt die Flächen, auf denen das Feld die gewählten Werte hat, jede mit Farbe und Deckkraft.</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isowerte</translation>
    </message>
    <message>
        <source>The values whose surfaces are shown, each with its colour and opacity.</source>
        <translation>Die Werte, deren Flächen gezeigt werden, jeder mit Farbe und Deckkraft.</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Begrenzungsquader</translation>
    </message>
    <message>
        <source>Shows the edges of the box that the data fill.</source>
        <translation>Zeigt die Kanten des Quaders, den die Daten füllen.</translation>
    </message>
    <message>
        <source>Volumes on regular lattices</source>
        <translation>Volumen auf regelmäßigen Gittern</translation>
    </message>
    <message>
        <source>Reads NRRD files with attached or detached data, raw, gzip or text, and raw files that are described.</source>
        <translation>Liest NRRD-Dateien mit Daten darin oder daneben, roh, gzip oder Text, und beschriebene Rohdateien.</translation>
    </message>
    <message>
        <source>NRRD writer</source>
        <translation>NRRD-Schreiber</translation>
    </message>
    <message>
        <source>Writes volumes on regular lattices as NRRD files, raw or gzip.</source>
        <translation>Schreibt Volumen auf regelmäßigen Gittern als NRRD-Dateien, roh oder gzip.</translation>
    </message>
    <message>
        <source>NRRD volume (*.nrrd *.nhdr)</source>
        <translation>NRRD-Volumen (*.nrrd *.nhdr)</translation>
    </message>
    <message>
        <source>Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)</source>
        <translation>Rohes Volumen (*.raw *.bin *.binary *.dat *.img *.vol)</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Raw files: the number of points along x (which runs fastest), y and z, as in 256x256x128.</source>
        <translation>Rohdateien: die Zahl der Punkte entlang x (läuft am schnellsten), y und z, etwa 256x256x128.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Raw files: the type of a sample.</source>
        <translation>Rohdateien: der Typ eines Abtastwerts.</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Bytefolge</translation>
    </message>
    <message>
        <source>Raw files: little (PC) or big endian, for types of more than one byte.</source>
        <translation>Rohdateien: little (PC) oder big endian, für Typen aus mehr als einem Byte.</translation>
    </message>
    <message>
        <source>little</source>
        <translation>Little-Endian (PC)</translation>
    </message>
    <message>
        <source>big</source>
        <translation>Big-Endian</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Raw files: the length of a header before the samples.</source>
        <translation>Rohdateien: die Länge eines Kopfes vor den Abtastwerten.</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Raw files: the distance of neighbouring points along x, y and z, as in 1x1x2.5.</source>
        <translation>Rohdateien: der Abstand benachbarter Punkte entlang x, y und z, etwa 1x1x2.5.</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>Raw files: the position of the first point, as in 0,0,0.</source>
        <translation>Rohdateien: die Lage des ersten Punkts, etwa 0,0,0.</translation>
    </message>
    <message>
        <source>uint8</source>
        <translation>uint8</translation>
    </message>
    <message>
        <source>int8</source>
        <translation>int8</translation>
    </message>
    <message>
        <source>uint16</source>
        <translation>uint16</translation>
    </message>
    <message>
        <source>int16</source>
        <translation>int16</translation>
    </message>
    <message>
        <source>uint32</source>
        <translation>uint32</translation>
    </message>
    <message>
        <source>int32</source>
        <translation>int32</translation>
    </message>
    <message>
        <source>float</source>
        <translation>float</translation>
    </message>
    <message>
        <source>double</source>
        <translation>double</translation>
    </message>
    <message>
        <source>builder</source>
        <translation>Erbauer</translation>
    </message>
    <message>
        <source>renderer</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>reader</source>
        <translation>Leser</translation>
    </message>
    <message>
        <source>writer</source>
        <translation>Schreiber</translation>
    </message>
    <message>
        <source>editor</source>
        <translation>Editor</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>loaded</source>
        <translation>geladen</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>abgeschaltet</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>PLOT3D grids</source>
        <translation>PLOT3D-Gitter</translation>
    </message>
    <message>
        <source>Reads curvilinear grids with a scalar of their solution from binary PLOT3D files of any byte order and precision.</source>
        <translation>Liest krummlinige Gitter mit einem Skalar ihrer Lösung aus binären PLOT3D-Dateien jeder Bytefolge und Genauigkeit.</translation>
    </message>
    <message>
        <source>PLOT3D writer</source>
        <translation>PLOT3D-Schreiber</translation>
    </message>
    <message>
        <source>Writes datasets on grids as a PLOT3D grid file and a solution file beside it.</source>
        <translation>Schreibt Datensätze auf Gittern als PLOT3D-Gitterdatei und eine Lösungsdatei daneben.</translation>
    </message>
    <message>
        <source>PLOT3D grid and solution (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</source>
        <translation>PLOT3D-Gitter und -Lösung (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</translation>
    </message>
    <message>
        <source>Which scalar of the solution: automatic takes the density, or if that is the same everywhere the first that varies.</source>
        <translation>Welcher Skalar der Lösung: „automatisch“ nimmt die Dichte, oder wenn sie überall gleich ist, den ersten, der sich ändert.</translation>
    </message>
    <message>
        <source>Solution file</source>
        <translation>Lösungsdatei</translation>
    </message>
    <message>
        <source>The PLOT3D solution of the grid; without it the one beside it with a fitting name.</source>
        <translation>Die PLOT3D-Lösung des Gitters; ohne sie die daneben mit passendem Namen.</translation>
    </message>
    <message>
        <source>VTK readers</source>
        <translation>VTK-Leser</translation>
    </message>
    <message>
        <source>Reads VTK, Exodus, EnSight, NetCDF, CGNS, MetaImage, NIfTI, TIFF, DICOM and more, by means of VTK.</source>
        <translation>Liest VTK, Exodus, EnSight, NetCDF, CGNS, MetaImage, NIfTI, TIFF, DICOM und mehr, mit Hilfe von VTK.</translation>
    </message>
    <message>
        <source>Of arrays with several components: the number of one, from 0, or &apos;magnitude&apos;.</source>
        <translation>Bei Feldern mit mehreren Komponenten: die Nummer einer, ab 0, oder „magnitude“ für den Betrag.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Of files with several time steps: which one, from 1.</source>
        <translation>Bei Dateien mit mehreren Zeitschritten: welcher, ab 1.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Of files with several blocks or parts: one, by name or number from 1; without it all irregular meshes that have the values, or the first grid.</source>
        <translation>Bei Dateien mit mehreren Blöcken oder Teilen: einer, mit Namen oder Nummer ab 1; ohne ihn alle unregelmäßigen Netze, die die Werte haben, oder das erste Gitter.</translation>
    </message>
    <message>
        <source>VTK XML (*.vti *.vtr *.vts *.vtu *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</source>
        <translation>VTK XML (*.vti *.vtr *.vts *.vtu *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</translation>
    </message>
    <message>
        <source>VTK legacy (*.vtk)</source>
        <translation>VTK, altes Format (*.vtk)</translation>
    </message>
    <message>
        <source>VTK HDF (*.vtkhdf *.hdf)</source>
        <translation>VTK HDF (*.vtkhdf *.hdf)</translation>
    </message>
    <message>
        <source>Exodus II (*.ex2 *.exo *.exii *.e *.g)</source>
        <translation>Exodus II (*.ex2 *.exo *.exii *.e *.g)</translation>
    </message>
    <message>
        <source>EnSight (*.case *.encas)</source>
        <translation>EnSight (*.case *.encas)</translation>
    </message>
    <message>
        <source>NetCDF, CF conventions (*.nc *.cdf)</source>
        <translation>NetCDF, CF-Konventionen (*.nc *.cdf)</translation>
    </message>
    <message>
        <source>CGNS (*.cgns)</source>
        <translation>CGNS (*.cgns)</translation>
    </message>
    <message>
        <source>MetaImage (*.mhd *.mha)</source>
        <translation>MetaImage (*.mhd *.mha)</translation>
    </message>
    <message>
        <source>NIfTI (*.nii *.nii.gz)</source>
        <translation>NIfTI (*.nii *.nii.gz)</translation>
    </message>
    <message>
        <source>MRC electron microscopy (*.mrc *.ccp4 *.map)</source>
        <translation>MRC-Elektronenmikroskopie (*.mrc *.ccp4 *.map)</translation>
    </message>
    <message>
        <source>TIFF stack (*.tif *.tiff)</source>
        <translation>TIFF-Stapel (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>DICOM series (*.dcm *.dicom)</source>
        <translation>DICOM-Serie (*.dcm *.dicom)</translation>
    </message>
    <message>
        <source>PLOT3D, also text (*.xyz *.x *.g *.p3d *.q)</source>
        <translation>PLOT3D, auch Text (*.xyz *.x *.g *.p3d *.q)</translation>
    </message>
    <message>
        <source>GAMBIT (*.neu)</source>
        <translation>GAMBIT (*.neu)</translation>
    </message>
    <message>
        <source>Fluent (*.cas)</source>
        <translation>Fluent (*.cas)</translation>
    </message>
    <message>
        <source>OpenFOAM (*.foam controlDict)</source>
        <translation>OpenFOAM (*.foam controlDict)</translation>
    </message>
    <message>
        <source>Tecplot text (*.tec *.tp)</source>
        <translation>Tecplot-Text (*.tec *.tp)</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Which grid of a PLOT3D file that holds several, from 1; 0 takes the only one.</source>
        <translation>Welches Gitter einer PLOT3D-Datei mit mehreren, von 1 an; 0 nimmt das einzige.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>density</source>
        <translation>density</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>pressure</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energy</translation>
    </message>
    <message>
        <source>velocity_magnitude</source>
        <translation>velocity_magnitude</translation>
    </message>
    <message>
        <source>momentum_magnitude</source>
        <translation>momentum_magnitude</translation>
    </message>
    <message>
        <source>momentum_x</source>
        <translation>momentum_x</translation>
    </message>
    <message>
        <source>momentum_y</source>
        <translation>momentum_y</translation>
    </message>
    <message>
        <source>momentum_z</source>
        <translation>momentum_z</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>temperature</translation>
    </message>
    <message>
        <source>mach</source>
        <translation>mach</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Shows the field as a translucent cloud: a transfer function gives each value its colour and opacity.</source>
        <translation>Zeigt das Feld als durchscheinende Wolke: Eine Transferfunktion gibt jedem Wert Farbe und Deckkraft.</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Shows the field as a volume that is finer inside the focus than outside, blended at its border.</source>
        <translation>Zeigt das Feld als Volumen, das im Fokus feiner ist als außerhalb und an dessen Rand überblendet.</translation>
    </message>
    <message>
        <source>Volume with isosurfaces</source>
        <translation>Volumen mit Isoflächen</translation>
    </message>
    <message>
        <source>Shows the field as a translucent cloud with surfaces of chosen values in it.</source>
        <translation>Zeigt das Feld als durchscheinende Wolke, in der Flächen gewählter Werte liegen.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>The colour and the opacity of each value.</source>
        <translation>Farbe und Deckkraft jedes Wertes.</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Beleuchtet</translation>
    </message>
    <message>
        <source>Lights the volume, as if a surface lay across the direction in which its values change most.</source>
        <translation>Beleuchtet das Volumen, als läge quer zur Richtung, in der sich seine Werte am stärksten ändern, eine Fläche.</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Cuts away what lies before a plane: nx,ny,nz,offset shows the points with nx x + ny y + nz z &gt;= offset.</source>
        <translation>Schneidet weg, was vor einer Ebene liegt: nx,ny,nz,Abstand zeigt die Punkte mit nx x + ny y + nz z &gt;= Abstand.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>How surfaces and volume are put in order: &apos;exact&apos;, or as the paper did &apos;with-cell&apos;, where the part of a surface in a cell is drawn before the cell.</source>
        <translation>Wie Flächen und Volumen geordnet werden: &apos;exakt&apos; oder wie im Aufsatz &apos;mit der Zelle&apos;, wo das Stück einer Fläche in einer Zelle vor der Zelle gezeichnet wird.</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>with-cell</source>
        <translation>mit der Zelle</translation>
    </message>
    <message>
        <source>Decimation by edge collapse</source>
        <translation>Vergröberung durch Kantenschrumpfen</translation>
    </message>
    <message>
        <source>Starts from the whole mesh and takes away the points that matter least; takes meshes of any shape and keeps their cavities.</source>
        <translation>Beginnt mit dem ganzen Netz und nimmt die Punkte weg, auf die es am wenigsten ankommt; nimmt Netze jeder Form und erhält ihre Hohlräume.</translation>
    </message>
    <message>
        <source>The error at which to stop; 0 goes on to the coarsest mesh.</source>
        <translation>Der Fehler, bei dem aufgehört wird; 0 geht bis zum gröbsten Netz.</translation>
    </message>
    <message>
        <source>Which point goes next: &apos;exact&apos; takes the one whose loss does the least harm, for the fewest points; &apos;paper&apos; estimates that by gradients and planes, as the paper did; &apos;rounds&apos; takes many points at a time that do not touch, so that a focus region needs the least besides.</source>
        <translation>Welcher Punkt als nächster geht: „exact“ nimmt den, dessen Verlust am wenigsten schadet, für die wenigsten Punkte; „paper“ schätzt das durch Gradienten und Ebenen, wie der Aufsatz; „rounds“ nimmt viele Punkte auf einmal, die einander nicht berühren, so dass ein Fokusbereich am wenigsten sonst braucht.</translation>
    </message>
    <message>
        <source>rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>Evaluating vertices</source>
        <translation>Die Knoten werden bewertet</translation>
    </message>
    <message>
        <source>Collapsing</source>
        <translation>Kanten schrumpfen</translation>
    </message>
    <message>
        <source>Scattered points have no tetrahedra that decimation could begin with. Refine them instead.</source>
        <translation>Verstreute Punkte haben keine Tetraeder, mit denen die Vergröberung beginnen könnte. Verfeinern Sie sie stattdessen.</translation>
    </message>
    <message>
        <source>A tetrahedral mesh needs a cell: two points or more along each axis.</source>
        <translation>Ein Tetraedernetz braucht eine Zelle: zwei Punkte oder mehr entlang jeder Achse.</translation>
    </message>
    <message>
        <source>Transfer function editor</source>
        <translation>Editor der Transferfunktion</translation>
    </message>
    <message>
        <source>Edits the colour and the opacity of each value, over how often the values occur.</source>
        <translation>Bearbeitet Farbe und Deckkraft jedes Wertes über der Häufigkeit der Werte.</translation>
    </message>
    <message>
        <source>electron density of the C60 molecule, a hollow ball of smooth bumps</source>
        <translation>Elektronendichte des C60-Moleküls, eine hohle Kugel aus glatten Hügeln</translation>
    </message>
    <message>
        <source>probability density of the hydrogen atom&apos;s 3d electron: two lobes and a ring</source>
        <translation>Wahrscheinlichkeitsdichte des 3d-Elektrons im Wasserstoffatom: zwei Keulen und ein Ring</translation>
    </message>
    <message>
        <source>the test signal of Marschner and Lobb: ripples that are hard to reproduce</source>
        <translation>das Testsignal von Marschner und Lobb: Wellen, die schwer wiederzugeben sind</translation>
    </message>
    <message>
        <source>white noise, the worst case: no sample tells of its neighbour</source>
        <translation>weißes Rauschen, der schlimmste Fall: Kein Wert sagt etwas über seinen Nachbarn</translation>
    </message>
    <message>
        <source>flow in front of a hemisphere: a curvilinear grid whose axis is collapsed</source>
        <translation>Strömung vor einer Halbkugel: ein krummliniges Gitter mit zusammengefallener Achse</translation>
    </message>
    <message>
        <source>flow around a cylinder: a curvilinear grid that closes on itself</source>
        <translation>Strömung um einen Zylinder: ein krummliniges Gitter, das sich in sich schließt</translation>
    </message>
    <message>
        <source>flow through a bent duct: a curvilinear grid</source>
        <translation>Strömung durch einen gebogenen Kanal: ein krummliniges Gitter</translation>
    </message>
    <message>
        <source>a layer at a wall: a rectilinear grid with spacings that grow</source>
        <translation>eine Schicht an einer Wand: ein rechtwinkliges Gitter mit wachsenden Abständen</translation>
    </message>
    <message>
        <source>random points in a ball, with waves that grow finer outwards</source>
        <translation>zufällige Punkte in einer Kugel, mit Wellen, die nach außen feiner werden</translation>
    </message>
    <message>
        <source>stress in a plate with five holes and a closed cavity: an irregular mesh</source>
        <translation>Spannung in einer Platte mit fünf Löchern und einem geschlossenen Hohlraum: ein unregelmäßiges Netz</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Berandung</translation>
    </message>
    <message>
        <source>Shows where the mesh ends, holes and cavities included: &apos;translucent&apos; in one light colour, so that one sees what is inside within its walls, or in the colours that the transfer function gives the &apos;values&apos; there.</source>
        <translation>Zeigt, wo das Netz endet, mit Löchern und Hohlräumen: „durchscheinend“ in einer hellen Farbe, so dass man sieht, was darin ist, oder in den Farben, die die Transferfunktion den „Werten“ dort gibt.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>translucent</source>
        <translation>durchscheinend</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>The opacity of a translucent boundary; 1 hides what lies behind.</source>
        <translation>Die Deckkraft einer durchscheinenden Berandung; 1 verdeckt, was dahinter liegt.</translation>
    </message>
    <message>
        <source>Back faces only</source>
        <translation>Nur Rückseiten</translation>
    </message>
    <message>
        <source>Shows only the far walls of the boundary, seen from within, and leaves out those that face the camera.</source>
        <translation>Zeigt nur die hinteren Wände des Randes, von innen, und lässt die der Kamera zugewandten weg.</translation>
    </message>
    <message>
        <source>Finest error</source>
        <translation>Feinster Fehler</translation>
    </message>
    <message>
        <source>Leaves meshes of smaller errors out of the model, so that it is smaller; 0 keeps everything.</source>
        <translation>Lässt Netze mit kleineren Fehlern aus dem Modell weg, sodass es kleiner wird; 0 behält alles.</translation>
    </message>
    <message>
        <source>The cells along an edge of the blocks that are refined independently, in memory for a few of them; &apos;none&apos; refines the dataset as a whole; &apos;automatic&apos; takes blocks where a lattice is large. The blocks of a curvilinear grid are refined together, all in memory.</source>
        <translation>Die Zellen entlang einer Kante der Blöcke, die unabhängig verfeinert werden, mit Speicher für einige davon; „keine“ verfeinert den Datensatz als Ganzes; „automatisch“ nimmt Blöcke, wo ein Gitter groß ist. Die Blöcke krummliniger Gitter werden gemeinsam verfeinert, alle im Speicher.</translation>
    </message>
    <message>
        <source>For curvilinear and irregular data: the warping at which to stop. Its ratio to the error says how much the shape counts against the values. If one of the two is 0, it is the same number as the other.</source>
        <translation>Für krummlinige und unregelmäßige Daten: die Verwerfung, bei der aufgehört wird. Ihr Verhältnis zum Fehler sagt, wie viel die Form gegenüber den Werten zählt. Ist eines der beiden 0, gilt dafür die Zahl des anderen.</translation>
    </message>
</context>
<context>
    <name>PointClipboard</name>
    <message>
        <source>The clipboard holds no points of a transfer function. Copy some here or in another window. %1</source>
        <translation>Die Zwischenablage enthält keine Punkte einer Transferfunktion. Kopieren Sie welche hier oder in einem anderen Fenster. %1</translation>
    </message>
</context>
<context>
    <name>PresetNames</name>
    <message>
        <source>Cool to warm</source>
        <translation>Kalt bis warm</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Sequential: opaque where values are large</source>
        <translation>Sequentiell: deckend, wo die Werte groß sind</translation>
    </message>
    <message>
        <source>Diverging: opaque at both ends</source>
        <translation>Divergierend: deckend an beiden Enden</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 × %1 × %1 points</source>
        <translation>%1 × %1 × %1 Punkte</translation>
    </message>
    <message>
        <source>Buckyball</source>
        <translation>Fußballmolekül</translation>
    </message>
    <message>
        <source>Electron density of a C60 molecule; regular grid, %1, computed by TAn. Look at the cage of atoms as an isosurface, and at how few tetrahedra are enough for an error of 1 %.</source>
        <translation>Elektronendichte eines C60-Moleküls; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: der Käfig der Atome als Isofläche, und wie wenige Tetraeder für einen Fehler von 1 % genügen.</translation>
    </message>
    <message>
        <source>Hydrogen atom</source>
        <translation>Wasserstoffatom</translation>
    </message>
    <message>
        <source>Probability density of the 3d electron; regular grid, %1, computed by TAn. Look at the two lobes and the ring, as a volume or as isosurfaces.</source>
        <translation>Aufenthaltswahrscheinlichkeit des 3d-Elektrons; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: die beiden Keulen und der Ring, als Volumen oder als Isoflächen.</translation>
    </message>
    <message>
        <source>Supersonic flow</source>
        <translation>Überschallströmung</translation>
    </message>
    <message>
        <source>Density in front of a hemisphere; curvilinear grid, %1, computed by TAn. Look at the bow shock, and at the grid that follows the body.</source>
        <translation>Dichte vor einer Halbkugel; krummliniges Gitter, %1, von TAn berechnet. Sehenswert: die Bugstoßwelle, und das Gitter, das dem Körper folgt.</translation>
    </message>
    <message>
        <source>Flow around a cylinder</source>
        <translation>Zylinderumströmung</translation>
    </message>
    <message>
        <source>Pressure of the flow; curvilinear grid that closes on itself, %1, computed by TAn. Look at the front, where the flow is stopped, and at the sides, where it is fastest.</source>
        <translation>Druck der Strömung; in sich geschlossenes krummliniges Gitter, %1, von TAn berechnet. Sehenswert: die Vorderseite, wo die Strömung gestaut wird, und die Seiten, wo sie am schnellsten ist.</translation>
    </message>
    <message>
        <source>Flow in a duct</source>
        <translation>Kanalströmung</translation>
    </message>
    <message>
        <source>Speed in a bent duct; curvilinear grid, %1, computed by TAn. Look at how the flow keeps to the outer wall of the bend.</source>
        <translation>Geschwindigkeit in einem gebogenen Kanal; krummliniges Gitter, %1, von TAn berechnet. Sehenswert: wie sich die Strömung an die Außenwand der Biegung hält.</translation>
    </message>
    <message>
        <source>Plate with holes</source>
        <translation>Platte mit Löchern</translation>
    </message>
    <message>
        <source>Stress in a plate with five holes and a closed cavity; irregular mesh, computed by TAn. Look at the boundary, which keeps its holes at every accuracy.</source>
        <translation>Spannung in einer Platte mit fünf Löchern und einem Hohlraum; unregelmäßiges Netz, von TAn berechnet. Sehenswert: der Rand, der seine Löcher in jeder Genauigkeit behält.</translation>
    </message>
    <message>
        <source>Scattered points</source>
        <translation>Verstreute Punkte</translation>
    </message>
    <message>
        <source>Waves that grow finer outwards, sampled at random points in a ball; %1, computed by TAn. Look at the volume: it needs no grid.</source>
        <translation>Wellen, die nach außen feiner werden, an zufälligen Punkten einer Kugel abgetastet; %1, von TAn berechnet. Sehenswert: das Volumen, das kein Gitter braucht.</translation>
    </message>
    <message>
        <source>Ripples</source>
        <translation>Wellen</translation>
    </message>
    <message>
        <source>The test signal of Marschner and Lobb; regular grid, %1, computed by TAn. Look at the fine ripples, which vanish first when the error grows.</source>
        <translation>Das Testsignal von Marschner und Lobb; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: die feinen Wellen, die bei wachsendem Fehler zuerst verschwinden.</translation>
    </message>
    <message>
        <source>Boundary layer</source>
        <translation>Grenzschicht</translation>
    </message>
    <message>
        <source>A layer at a wall; rectilinear grid with growing spacing, %1, computed by TAn. Look at how the tetrahedra crowd at the wall.</source>
        <translation>Eine Schicht an einer Wand; rechtwinkliges Gitter mit wachsenden Abständen, %1, von TAn berechnet. Sehenswert: wie sich die Tetraeder an der Wand drängen.</translation>
    </message>
    <message>
        <source>White noise</source>
        <translation>Weißes Rauschen</translation>
    </message>
    <message>
        <source>Random values, the worst case for any method; regular grid, %1, computed by TAn. Look at the statistics: even at a large error nearly all points are needed.</source>
        <translation>Zufallswerte, der schlimmste Fall für jedes Verfahren; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: die Statistik, denn auch bei einem großen Fehler werden fast alle Punkte gebraucht.</translation>
    </message>
</context>
<context>
    <name>Sentence</name>
    <message>
        <source>&apos;%1&apos; does not exist, or its folder may not be entered. Check the name.</source>
        <translation>„%1“ gibt es nicht, oder der Ordner ist nicht zugänglich. Prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a folder. Choose a file inside it.</source>
        <translation>„%1“ ist ein Ordner. Wählen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a device or a pipe. Give a file.</source>
        <translation>„%1“ ist ein Gerät oder eine Pipe. Wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. The copy may be incomplete: copy the file again.</source>
        <translation>„%1“ ist leer. Vielleicht ist die Kopie unvollständig: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2.</source>
        <translation>„%1“ kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: %2</source>
        <translation>„%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>%1. Check its name and folder.</source>
        <translation>%1. Prüfen Sie Name und Ordner.</translation>
    </message>
    <message>
        <source>%1. Ask its owner for the right to read it.</source>
        <translation>%1. Bitten Sie den Eigentümer um das Recht, sie zu lesen.</translation>
    </message>
    <message>
        <source>it is a folder. Name a file in it.</source>
        <translation>Das ist ein Ordner. Nennen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>it is not a regular file. Copy its content into one first.</source>
        <translation>Das ist keine gewöhnliche Datei. Kopieren Sie den Inhalt erst in eine.</translation>
    </message>
    <message>
        <source>Cannot open &apos;%1&apos;: too many files are open. Close some of them.</source>
        <translation>„%1“ kann nicht geöffnet werden: Zu viele Dateien sind offen. Schließen Sie einige.</translation>
    </message>
    <message>
        <source>No reader is installed.</source>
        <translation>Es ist kein Leser installiert.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; cannot be read: %2.</source>
        <translation>Die Datei „%1“ kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; is too large to be what is looked for here.</source>
        <translation>Die Datei „%1“ ist zu groß für das, was hier gesucht wird.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos;: %2</source>
        <translation>In „%1“: %2</translation>
    </message>
    <message>
        <source>it is empty. Get or make the file again.</source>
        <translation>Sie ist leer. Holen oder erzeugen Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it changed while it was read. Read it again.</source>
        <translation>Sie hat sich beim Lesen verändert. Lesen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it holds no points.</source>
        <translation>Sie enthält keine Punkte.</translation>
    </message>
    <message>
        <source>it is not a text.</source>
        <translation>Sie ist kein Text.</translation>
    </message>
    <message>
        <source>it is of no format that VTK reads.</source>
        <translation>Ihr Format liest VTK nicht.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. Choose one of these: %2.</source>
        <translation>Sie hat kein Feld „%1“. Wählen Sie eines von diesen: %2.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. There are: %2.</source>
        <translation>Sie hat kein Feld „%1“. Es gibt: %2.</translation>
    </message>
    <message>
        <source>it has no array with a number for each point or cell. Write it with one.</source>
        <translation>Sie hat kein Feld mit einer Zahl für jeden Punkt oder jede Zelle. Schreiben Sie sie mit einem.</translation>
    </message>
    <message>
        <source>it has no values, of points or of cells.</source>
        <translation>Sie hat keine Werte, weder von Punkten noch von Zellen.</translation>
    </message>
    <message>
        <source>it should hold %1, but there are only %2. It is cut short, or its description (sizes, type, bytes to skip) is wrong.</source>
        <translation>Sie sollte %1 enthalten, es sind aber nur %2. Sie ist abgeschnitten, oder die Beschreibung (Größen, Typ, zu überspringende Bytes) ist falsch.</translation>
    </message>
    <message>
        <source>it should hold %1, but there are %2, %3 too many. Its description is wrong: check the sizes, the type and the bytes to skip.</source>
        <translation>Sie sollte %1 enthalten, es sind aber %2, %3 zu viel. Die Beschreibung ist falsch: Prüfen Sie Größen, Typ und zu überspringende Bytes.</translation>
    </message>
    <message>
        <source>%1 samples of type %2, %3 bytes</source>
        <translation>%1 Abtastwerte vom Typ %2, %3 Bytes</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Bytes</translation>
    </message>
    <message>
        <source>%1 of its %2 samples are NaN or infinite, the first at point (%3). Replace them by numbers first.</source>
        <translation>%1 ihrer %2 Abtastwerte sind NaN oder unendlich, der erste am Punkt (%3). Ersetzen Sie sie zuerst durch Zahlen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has an unknown format. %2</source>
        <translation>„%1“ hat ein unbekanntes Format. %2</translation>
    </message>
    <message>
        <source>The manual and &apos;tan info --help&apos; list the files that are read; samples alone, without a header, are read as a raw file.</source>
        <translation>Das Handbuch und „tan info --help“ nennen die Dateien, die gelesen werden; Abtastwerte allein, ohne Kopf, werden als Rohdatei gelesen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is packed. Unpack it first, by &apos;%2&apos;, and open what is in it.</source>
        <translation>„%1“ ist gepackt. Entpacken Sie die Datei zuerst mit „%2“, und öffnen Sie, was darin ist.</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: %2 (It was unpacked by itself. If it names other files, unpack it beside them: gunzip.)</source>
        <translation>„%1“ kann nicht gelesen werden: %2 (Die Datei wurde für sich allein entpackt. Wenn sie andere nennt, entpacken Sie sie neben diesen: gunzip.)</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and damaged or cut short. The copy may be incomplete: copy the file again.</source>
        <translation>Sie ist mit gzip komprimiert und beschädigt oder abgeschnitten. Vielleicht ist die Kopie unvollständig: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and cannot be unpacked into &apos;%1&apos;: %2. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>Sie ist mit gzip komprimiert und kann nicht nach „%1“ entpackt werden: %2. Schaffen Sie dort Platz, setzen Sie TMPDIR auf einen Ordner mit mehr, oder entpacken Sie sie selbst (gunzip).</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and unpacks to more than %1, half of the room in &apos;%2&apos;. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>Sie ist mit gzip komprimiert und entpackt größer als %1, die Hälfte des Platzes in „%2“. Schaffen Sie dort Platz, setzen Sie TMPDIR auf einen Ordner mit mehr, oder entpacken Sie sie selbst (gunzip).</translation>
    </message>
    <message>
        <source>VTK says: %1 The file is damaged, incomplete, or of a kind that VTK does not know: copy or export it again.</source>
        <translation>VTK meldet: %1 Die Datei ist beschädigt, unvollständig oder von einer Art, die VTK nicht kennt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its header asks for %2. It is cut short: copy the file again.</source>
        <translation>Sie hat %1 Byte, und ihr Kopf verlangt %2. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its data file &apos;%1&apos; has %2 bytes, and its header asks for %3. It is cut short: copy the file again.</source>
        <translation>Ihre Datendatei „%1“ hat %2 Byte, und der Kopf verlangt %3. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its data file &apos;%1&apos; is missing. Copy it into the folder of this one: the two belong together.</source>
        <translation>Ihre Datendatei „%1“ fehlt. Kopieren Sie sie in den Ordner dieser Datei: Die beiden gehören zusammen.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; is missing. Copy it into the folder of this one: they belong together.</source>
        <translation>Ihre Datei „%1“ fehlt. Kopieren Sie sie in den Ordner dieser Datei: Sie gehören zusammen.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; ends in line %2, before the last %3. It is cut short: copy the file again.</source>
        <translation>Ihre Datei „%1“ endet in Zeile %2, zu früh für alle Angaben (%3). Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its variable &apos;%2&apos; reaches to byte %3. It is cut short, or was not written to its end: copy the file again, or export it again.</source>
        <translation>Sie hat %1 Byte, und ihre Variable „%2“ reicht bis Byte %3. Sie ist abgeschnitten oder wurde nicht zu Ende geschrieben: Kopieren Sie die Datei noch einmal, oder exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>page %1 lies behind its end, at %2 bytes. It is cut short: copy the file again.</source>
        <translation>Seite %1 liegt hinter ihrem Ende bei %2 Byte. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it ends within its header. It is cut short: copy the file again.</source>
        <translation>Sie endet in ihrem Kopf. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it ends within its appended data. It is cut short: copy the file again.</source>
        <translation>Sie endet in ihren angehängten Daten. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it is a list of files, one for each time step or part. Open one of its files, such as &apos;%1&apos;.</source>
        <translation>Sie ist eine Liste von Dateien, eine für jeden Zeitschritt oder Teil. Öffnen Sie eine davon, etwa „%1“.</translation>
    </message>
    <message>
        <source>it is a binary UCD file, and only text is read. Write it as text, or as .vtu, for instance with ParaView.</source>
        <translation>Sie ist eine binäre UCD-Datei, und nur Text wird gelesen. Schreiben Sie sie als Text oder als .vtu, etwa mit ParaView.</translation>
    </message>
    <message>
        <source>VTK needs more than %1 of memory for it, which files of its size do not need. It is damaged; if not, write it in another format (.vtu, .vti).</source>
        <translation>VTK braucht für sie mehr als %1 Speicher, was Dateien ihrer Größe nicht brauchen. Sie ist beschädigt; wenn nicht, schreiben Sie sie in einem anderen Format (.vtu, .vti).</translation>
    </message>
    <message>
        <source>VTK needs more than %1 of memory for it, half of what this machine has. It is damaged, or too large for this machine: take a part of it.</source>
        <translation>VTK braucht für sie mehr als %1 Speicher, die Hälfte dessen, was dieser Rechner hat. Sie ist beschädigt oder zu groß für diesen Rechner: Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>VTK needs more than %1 seconds of the processor for it, which files of its size do not need. It is damaged; if not, write it in another format (.vtu, .vti).</source>
        <translation>VTK braucht für sie mehr als %1 Sekunden des Prozessors, was Dateien ihrer Größe nicht brauchen. Sie ist beschädigt; wenn nicht, schreiben Sie sie in einem anderen Format (.vtu, .vti).</translation>
    </message>
    <message>
        <source>VTK needs more memory for it than the %1 that programs may take here. Raise the limit (ulimit -v).</source>
        <translation>VTK braucht für sie mehr Speicher als die %1, die Programme hier nehmen dürfen. Erhöhen Sie die Grenze (ulimit -v).</translation>
    </message>
    <message>
        <source>the system ended VTK, which it does when memory runs out. Close other programs, or take a part of the file.</source>
        <translation>Das System hat VTK beendet, was es tut, wenn der Speicher ausgeht. Schließen Sie andere Programme, oder nehmen Sie einen Teil der Datei.</translation>
    </message>
    <message>
        <source>VTK has waited for its disk for minutes. See whether the disk answers, or copy the file to another one.</source>
        <translation>VTK hat minutenlang auf seinen Datenträger gewartet. Sehen Sie nach, ob er antwortet, oder kopieren Sie die Datei auf einen anderen.</translation>
    </message>
    <message>
        <source>There are not enough memory, processes or open files to start the VTK readers (%1). Close other programs, or raise the limit (ulimit).</source>
        <translation>Speicher, Prozesse oder offene Dateien reichen nicht, um die VTK-Leser zu starten (%1). Schließen Sie andere Programme, oder erhöhen Sie die Grenze (ulimit).</translation>
    </message>
    <message>
        <source>The file ends without an end of line: if it was cut short there, its last number is wrong.</source>
        <translation>Die Datei endet ohne Zeilenende: Wenn sie dort abgeschnitten wurde, ist ihre letzte Zahl falsch.</translation>
    </message>
    <message>
        <source>1 cell is called linear and has the corners of a quadratic one: it was taken as such.</source>
        <translation>1 Zelle heißt linear und hat die Ecken einer quadratischen: Sie wurde als solche genommen.</translation>
    </message>
    <message>
        <source>%1 cells are called linear and have the corners of quadratic ones: they were taken as such.</source>
        <translation>%1 Zellen heißen linear und haben die Ecken von quadratischen: Sie wurden als solche genommen.</translation>
    </message>
    <message>
        <source>VTK&apos;s reader crashed. The file is damaged, larger than memory, or of a kind that VTK reads badly. Export it again, or in another format (.vtu, .vti).</source>
        <translation>Der Leser von VTK ist abgestürzt. Die Datei ist beschädigt, größer als der Arbeitsspeicher oder von einer Art, die VTK schlecht liest. Exportieren Sie sie neu oder in einem anderen Format (.vtu, .vti).</translation>
    </message>
    <message>
        <source>The VTK readers are not installed. Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; where the file lies (of a build of your own: build it anew after &apos;apt install libvtk9-dev&apos;), or convert the file to NRRD or CSV.</source>
        <translation>Die VTK-Leser sind nicht installiert. Installieren Sie das Paket tan-vtk-readers, das mit TAn kommt: „apt install ./tan-vtk-readers_*.deb“ dort, wo die Datei liegt (bei einem eigenen Bau: nach „apt install libvtk9-dev“ neu bauen), oder wandeln Sie die Datei in NRRD oder CSV um.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2. Copy the file again, or build it again.</source>
        <translation>„%1“ ist beschädigt: %2. Kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>its header makes no sense</source>
        <translation>Sein Kopf ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>the checksum of its header is wrong</source>
        <translation>Die Prüfsumme seines Kopfes ist falsch</translation>
    </message>
    <message>
        <source>the checksum of its text is wrong</source>
        <translation>Die Prüfsumme seines Textes ist falsch</translation>
    </message>
    <message>
        <source>the checksum of section &apos;%1&apos; is wrong</source>
        <translation>Die Prüfsumme des Abschnitts „%1“ ist falsch</translation>
    </message>
    <message>
        <source>it has %1 bytes and should have %2</source>
        <translation>Es hat %1 Bytes und sollte %2 haben</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; is missing</source>
        <translation>Der Abschnitt „%1“ fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is cut short: it has %2 bytes and should have %3. Copy the file again, or build it again.</source>
        <translation>„%1“ ist abgeschnitten: Es hat %2 Bytes und sollte %3 haben. Kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. Models are made by &apos;tan build&apos;.</source>
        <translation>„%1“ ist leer. Modelle werden aus Datensätzen gebaut.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a TAn model: it does not begin like one. Models are made by &apos;tan build&apos;.</source>
        <translation>„%1“ ist kein TAn-Modell: Es beginnt nicht wie eines. Modelle werden aus Datensätzen gebaut.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was written with the other byte order. Build it again on this machine.</source>
        <translation>„%1“ wurde in der anderen Bytefolge geschrieben. Bauen Sie es auf diesem Rechner neu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has format version %2; this program reads up to version %3. Install a later version of TAn.</source>
        <translation>„%1“ hat die Formatversion %2; dieses Programm liest bis Version %3. Installieren Sie eine spätere Version von TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open. Open it again; if that fails, copy the file again, or build it again.</source>
        <translation>„%1“ wurde abgeschnitten oder geändert, während es offen war. Öffnen Sie es noch einmal; gelingt das nicht, kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open, so that what was made of it would be wrong. Open it again; if that fails, get or make the file again.</source>
        <translation>„%1“ wurde abgeschnitten oder geändert, während die Datei offen war, sodass falsch wäre, was daraus gemacht wurde. Öffnen Sie sie noch einmal; gelingt das nicht, holen oder erzeugen Sie sie neu.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2. %3</source>
        <translation>„%1“ kann nicht geschrieben werden: %2. %3</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; does not exist: create it or choose another.</source>
        <translation>Den Ordner „%1“ gibt es nicht: Legen Sie ihn an, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a folder: choose another.</source>
        <translation>„%1“ ist kein Ordner: Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>It is a folder: name a file in it.</source>
        <translation>Das ist ein Ordner: Nennen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>Choose another folder, or change the permissions of this one.</source>
        <translation>Wählen Sie einen anderen Ordner, oder ändern Sie die Rechte von diesem.</translation>
    </message>
    <message>
        <source>Choose a folder on a disk that can be written.</source>
        <translation>Wählen Sie einen Ordner auf einem beschreibbaren Datenträger.</translation>
    </message>
    <message>
        <source>Free some space or choose another disk.</source>
        <translation>Schaffen Sie Platz, oder wählen Sie einen anderen Datenträger.</translation>
    </message>
    <message>
        <source>Choose a disk that allows larger files, or raise the limit (ulimit -f).</source>
        <translation>Wählen Sie einen Datenträger, der größere Dateien erlaubt, oder heben Sie die Grenze an (ulimit -f).</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Wählen Sie einen kürzeren Namen.</translation>
    </message>
    <message>
        <source>Choose another folder or disk.</source>
        <translation>Wählen Sie einen anderen Ordner oder Datenträger.</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>Es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>Die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Choose another name, or make it writable.</source>
        <translation>Wählen Sie einen anderen Namen, oder machen Sie sie beschreibbar.</translation>
    </message>
    <message>
        <source>it does not name a file</source>
        <translation>Das benennt keine Datei</translation>
    </message>
    <message>
        <source>Name a file.</source>
        <translation>Nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>Cannot work in &apos;%1&apos;: %2. %3</source>
        <translation>In „%1“ kann nicht gearbeitet werden: %2. %3</translation>
    </message>
    <message>
        <source>another program is building this model</source>
        <translation>Ein anderes Programm baut dieses Modell gerade</translation>
    </message>
    <message>
        <source>Wait for it, or give the model another name.</source>
        <translation>Warten Sie darauf, oder geben Sie dem Modell einen anderen Namen.</translation>
    </message>
    <message>
        <source>Choose another folder for the model.</source>
        <translation>Wählen Sie einen anderen Ordner für das Modell.</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Keine Berechtigung</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Nicht erlaubt</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>Nicht genug Speicher</translation>
    </message>
    <message>
        <source>Resource temporarily unavailable</source>
        <translation>Im Augenblick nicht verfügbar</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät oder Datei in Benutzung</translation>
    </message>
    <message>
        <source>Invalid cross-device link</source>
        <translation>Auf einem anderen Datenträger</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Kein Ordner</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Das ist ein Ordner</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>Ungültiges Argument</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Too many open files in system</source>
        <translation>Zu viele offene Dateien im ganzen System</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Zu viele symbolische Verweise hintereinander</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherkontingent überschritten</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Die Datei gibt es auf dem Server nicht mehr</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is the input &apos;%2&apos;. Give the output another name.</source>
        <translation>Das Ziel „%1“ ist die Quelle „%2“. Geben Sie dem Ziel einen anderen Namen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; exists and is no TAn model, so it is not overwritten. Give the model another name, or remove that file first.</source>
        <translation>„%1“ gibt es und ist kein TAn-Modell, wird also nicht überschrieben. Geben Sie dem Modell einen anderen Namen, oder entfernen Sie die Datei zuerst.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written: %2. Choose another place.</source>
        <translation>„%1“ kann nicht geschrieben werden: %2. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; for samples cannot be made: %2. Make it writable, or free some space.</source>
        <translation>Der Ordner „%1“ für Beispiele kann nicht angelegt werden: %2. Machen Sie ihn beschreibbar, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ends in none of .vtu, .vtk and .ply, the formats in which meshes are written, nor of .vtp, .stl, .obj and .glb, for their boundary alone. Choose one of these endings.</source>
        <translation>„%1“ endet weder auf .vtu, .vtk oder .ply, in denen Netze geschrieben werden, noch auf .vtp, .stl, .obj oder .glb, für ihren Rand allein. Wählen Sie eine dieser Endungen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ends in none of .vtp, .vtk, .vtu, .ply, .stl, .obj and .glb, the formats in which surfaces are written. Choose one of these endings.</source>
        <translation>„%1“ endet auf keine von .vtp, .vtk, .vtu, .ply, .stl, .obj und .glb, in denen Flächen geschrieben werden. Wählen Sie eine dieser Endungen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ends in neither .csv nor .json, the formats in which statistics are written. Choose one of these endings.</source>
        <translation>„%1“ endet weder auf .csv noch auf .json, in denen Statistiken geschrieben werden. Wählen Sie eine dieser Endungen.</translation>
    </message>
    <message>
        <source>There is no surface to save: add an isovalue, or show one.</source>
        <translation>Es gibt keine Fläche zu speichern: Fügen Sie einen Isowert hinzu, oder zeigen Sie einen.</translation>
    </message>
    <message>
        <source>A film needs two key frames at least. Add another view.</source>
        <translation>Ein Film braucht mindestens zwei Schlüsselbilder. Fügen Sie noch eine Ansicht hinzu.</translation>
    </message>
    <message>
        <source>The video could not be made: %1 says &quot;%2&quot;. Choose another format, or PNG pictures.</source>
        <translation>Das Video konnte nicht erzeugt werden: %1 meldet „%2“. Wählen Sie ein anderes Format oder PNG-Bilder.</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos;.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um „%1“ zu schreiben.</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos;. Close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um „%1“ zu schreiben. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Not enough memory to read &apos;%1&apos;. Close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um „%1“ zu lesen. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>There is not enough memory for the mesh at this accuracy. Choose a coarser one, or close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht für das Netz dieser Genauigkeit. Wählen Sie eine gröbere, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>There is not enough memory for this mesh. Ask for a larger error, a smaller focus or a budget.</source>
        <translation>Der Arbeitsspeicher reicht nicht für dieses Netz. Wählen Sie einen größeren Fehler, einen kleineren Fokus oder ein Budget.</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh of the focus. Choose a larger error or a smaller focus.</source>
        <translation>Der Arbeitsspeicher reicht nicht für das Netz des Fokus. Wählen Sie einen größeren Fehler oder einen kleineren Fokus.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>Der Arbeitsspeicher reicht nicht für ein Bild dieser Größe.</translation>
    </message>
    <message>
        <source>Not enough memory for a picture of this size and scene. Make the picture smaller or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht für ein Bild dieser Größe und Szene. Machen Sie das Bild kleiner, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht für die Isofläche. Schließen Sie andere Programme, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurfaces. Show fewer of them or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht für die Isoflächen. Zeigen Sie weniger davon, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>Not enough memory to draw this mesh as a volume. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses Netz als Volumen zu zeichnen. Schließen Sie andere Programme, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>Not enough memory for this part. Take a smaller one.</source>
        <translation>Der Arbeitsspeicher reicht nicht für diesen Teil. Nehmen Sie einen kleineren.</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh. Take a part of it.</source>
        <translation>Der Arbeitsspeicher reicht nicht für das Netz. Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>Not enough memory to refine this lattice. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses Gitter zu verfeinern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher, oder nehmen Sie einen Teil der Daten.</translation>
    </message>
    <message>
        <source>Not enough memory to refine this grid. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses krummlinige Gitter zu verfeinern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher, oder nehmen Sie einen Teil der Daten.</translation>
    </message>
    <message>
        <source>Not enough memory to refine these points. Close other programs, use a machine with more memory, or take a part of the points.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um diese Punkte zu verfeinern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher oder einen Teil der Punkte.</translation>
    </message>
    <message>
        <source>Not enough memory to decimate this mesh. Close other programs, use a machine with more memory, or take a part of the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses Netz zu vergröbern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher oder einen Teil der Daten.</translation>
    </message>
    <message>
        <source>The finest error (%1 %) is larger than the error at which to stop (%2 %). Choose a smaller finest error, or 0 to keep everything.</source>
        <translation>Der feinste Fehler (%1 %) ist größer als der Fehler, bei dem aufgehört wird (%2 %). Wählen Sie einen kleineren feinsten Fehler, oder 0, um alles zu behalten.</translation>
    </message>
    <message>
        <source>Decimation of %1 takes about %2 of memory, and this machine has %3. Take a region of it or fewer samples, or, of a lattice or grid, refine it instead.</source>
        <translation>Die Vergröberung von %1 braucht etwa %2 Arbeitsspeicher, und dieser Rechner hat %3. Nehmen Sie einen Bereich davon oder weniger Punkte, oder verfeinern Sie es stattdessen, wenn es ein Gitter ist.</translation>
    </message>
    <message>
        <source>%1 points and %2 tetrahedra</source>
        <translation>%1 Punkten und %2 Tetraedern</translation>
    </message>
    <message>
        <source>The memory of this machine is not enough for &apos;%1&apos; here. Close other programs, or give it smaller data.</source>
        <translation>Der Arbeitsspeicher dieses Rechners reicht hier nicht für „%1“. Schließen Sie andere Programme, oder nehmen Sie kleinere Daten.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; failed: %2. This is a mistake in the plugin; tell its author.</source>
        <translation>Das Plugin „%1“ ist gescheitert: %2. Das ist ein Fehler des Plugins; sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>The build was stopped before there was a mesh of known error, so there is nothing to keep.</source>
        <translation>Der Bau wurde angehalten, ehe es ein Netz mit bekanntem Fehler gab; es gibt also nichts zu behalten.</translation>
    </message>
    <message>
        <source>The build needs about %1 on the disk of &apos;%2&apos; (%3), and %4 are free. Free some space, choose another disk or ask for a larger error.</source>
        <translation>Der Bau braucht etwa %1 auf dem Datenträger von „%2“ (%3), und %4 sind frei. Schaffen Sie Platz, wählen Sie einen anderen Datenträger oder einen größeren Fehler.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; does not accept &apos;%2&apos;: %3</source>
        <translation>„%1“ nimmt „%2“ nicht an: %3</translation>
    </message>
    <message>
        <source>The block size &apos;%1&apos; is neither &quot;automatic&quot; nor &quot;none&quot; nor a number of cells of at least 1.</source>
        <translation>Die Blockgröße „%1“ ist weder „automatic“ noch „none“ noch eine Zahl von Zellen ab 1.</translation>
    </message>
    <message>
        <source>The weight &apos;%1&apos; cannot be used: %2.</source>
        <translation>Das Gewicht „%1“ ist nicht brauchbar: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>it has %1 numbers, and the form is %2</source>
        <translation>Es hat %1 Zahlen, und die Form ist %2</translation>
    </message>
    <message>
        <source>its reach is %1 and must be at least 0</source>
        <translation>Seine Reichweite ist %1 und muss mindestens 0 sein</translation>
    </message>
    <message>
        <source>its reach is %1 and must be above 0</source>
        <translation>Seine Reichweite ist %1 und muss größer als 0 sein</translation>
    </message>
    <message>
        <source>its floor is %1 and must be from %2 to 1</source>
        <translation>Sein Mindestwert ist %1 und muss von %2 bis 1 sein</translation>
    </message>
    <message>
        <source>a weight begins with &apos;point:&apos;, &apos;box:&apos; or &apos;value:&apos;</source>
        <translation>Ein Gewicht beginnt mit „point:“, „box:“ oder „value:“</translation>
    </message>
    <message>
        <source>its first corner must be the smaller one along every axis</source>
        <translation>Seine erste Ecke muss entlang jeder Achse die kleinere sein</translation>
    </message>
    <message>
        <source>The mesh has %1. Repair the mesh in the program that made it.</source>
        <translation>Das Netz hat %1. Reparieren Sie das Netz in dem Programm, das es erzeugt hat.</translation>
    </message>
    <message>
        <source>No cell of the mesh has a volume: nothing is left.</source>
        <translation>Keine Zelle des Netzes hat ein Volumen: Es bleibt nichts übrig.</translation>
    </message>
    <message>
        <source>The coarsest mesh of &apos;%1&apos; has %2 tetrahedra, more than the budget of %3. Allow at least as many.</source>
        <translation>Das gröbste Netz von „%1“ hat %2 Tetraeder, mehr als das Budget von %3. Erlauben Sie mindestens so viele.</translation>
    </message>
    <message>
        <source>The coarsest mesh has %1 tetrahedra, more than the budget of %2. Allow at least as many.</source>
        <translation>Das gröbste Netz hat %1 Tetraeder, mehr als das Budget von %2. Erlauben Sie mindestens so viele.</translation>
    </message>
    <message>
        <source>The error in the focus is larger than that outside. Swap them.</source>
        <translation>Der Fehler im Fokus ist größer als der außerhalb. Vertauschen Sie die beiden.</translation>
    </message>
    <message>
        <source>The mesh of the focus became too large. Choose a larger error or a smaller focus.</source>
        <translation>Das Netz des Fokus wurde zu groß. Wählen Sie einen größeren Fehler oder einen kleineren Fokus.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no clip plane: give four numbers nx,ny,nz,offset, the first three not all zero; points with nx x + ny y + nz z &gt;= offset are shown.</source>
        <translation>„%1“ ist keine Schnittebene: Geben Sie vier Zahlen nx,ny,nz,Abstand an, die ersten drei nicht alle null; gezeigt werden Punkte mit nx x + ny y + nz z &gt;= Abstand.</translation>
    </message>
    <message>
        <source>The model of the session cannot be opened. %1</source>
        <translation>Das Modell der Sitzung kann nicht geöffnet werden. %1</translation>
    </message>
    <message>
        <source>%1: The session cannot be read: %2</source>
        <translation>%1: Die Sitzung kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>its &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation>„format“ ist nicht „%1“.</translation>
    </message>
    <message>
        <source>this program knows version %1 of sessions only.</source>
        <translation>Dieses Programm kennt nur Version %1 von Sitzungen.</translation>
    </message>
    <message>
        <source>it names no model in &quot;model.path&quot;.</source>
        <translation>Sie nennt kein Modell in „model.path“.</translation>
    </message>
    <message>
        <source>The transfer function cannot be read: %1</source>
        <translation>Die Transferfunktion kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The transfer function cannot be read. %1</source>
        <translation>Die Transferfunktion kann nicht gelesen werden. %1</translation>
    </message>
    <message>
        <source>The ParaView preset cannot be read: %1</source>
        <translation>Die ParaView-Vorlage kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be used: %2.</source>
        <translation>Die Vorlage „%1“ kann nicht benutzt werden: %2.</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be changed: %2. Check the rights of its folder, and that there is space.</source>
        <translation>Die Vorlage „%1“ kann nicht geändert werden: %2. Prüfen Sie die Rechte des Ordners, und ob Platz ist.</translation>
    </message>
    <message>
        <source>Not valid JSON: %1</source>
        <translation>Kein gültiges JSON: %1</translation>
    </message>
    <message>
        <source>This is no camera. %1</source>
        <translation>Das ist keine Kamera. %1</translation>
    </message>
    <message>
        <source>This is no camera: it holds no JSON object, in braces.</source>
        <translation>Das ist keine Kamera: Es enthält kein JSON-Objekt in geschweiften Klammern.</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera %2 (%3).</source>
        <translation>Der Schlüssel „%1“ der Kamera %2 (%3).</translation>
    </message>
    <message>
        <source>is no number from %1 to %2</source>
        <translation>ist keine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>ist weder true noch false</translation>
    </message>
    <message>
        <source>is not a list of three numbers</source>
        <translation>ist keine Liste von drei Zahlen</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>ist nicht bekannt</translation>
    </message>
    <message>
        <source>expected a value (%1).</source>
        <translation>Ein Wert fehlt (%1).</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for a picture of this size. Make it smaller, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für ein Bild dieser Größe. Machen Sie es kleiner, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for this picture. Make it smaller, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für dieses Bild. Machen Sie es kleiner, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for this volume. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für dieses Volumen. Senken Sie die Genauigkeit des Netzes, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for this surface. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für diese Fläche. Senken Sie die Genauigkeit des Netzes, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The OpenGL context cannot be used, perhaps because the graphics card was reset. Use the CPU back end.</source>
        <translation>Der OpenGL-Kontext ist nicht benutzbar, vielleicht weil die Grafikkarte zurückgesetzt wurde. Lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The OpenGL driver has version %1; TAn needs 3.3. Use the CPU back end, or another driver.</source>
        <translation>Der OpenGL-Treiber hat Version %1; TAn braucht 3.3. Lassen Sie den Prozessor zeichnen, oder nehmen Sie einen anderen Treiber.</translation>
    </message>
    <message>
        <source>OpenGL cuts scenes by at most %1 planes. Take fewer, or use the CPU back end.</source>
        <translation>OpenGL schneidet Szenen an höchstens %1 Ebenen. Nehmen Sie weniger, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which is not here or cannot be used. Install it.</source>
        <translation>Es braucht das Plugin „%1“, das fehlt oder nicht benutzbar ist. Installieren Sie es.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which cannot be used: %2</source>
        <translation>Es braucht das Plugin „%1“, das nicht benutzbar ist: %2</translation>
    </message>
    <message>
        <source>It is not a plugin, or is damaged: %1 Install it again, or remove the file.</source>
        <translation>Es ist kein Plugin oder beschädigt: %1 Installieren Sie es noch einmal, oder entfernen Sie die Datei.</translation>
    </message>
    <message>
        <source>Another plugin has the same id and was found first: %1. Remove one of the two.</source>
        <translation>Ein anderes Plugin hat dieselbe Kennung und wurde zuerst gefunden: %1. Entfernen Sie eines der beiden.</translation>
    </message>
    <message>
        <source>The library %1 is missing. %2</source>
        <translation>Die Bibliothek %1 fehlt. %2</translation>
    </message>
    <message>
        <source>It was built with Qt %1, and this program runs with Qt %2. Install a build of the plugin for this Qt.</source>
        <translation>Es wurde mit Qt %1 gebaut, und dieses Programm läuft mit Qt %2. Installieren Sie das Plugin für dieses Qt.</translation>
    </message>
    <message>
        <source>A part of %1 of the %2 points.</source>
        <translation>Ein Teil von %1 der %2 Punkte.</translation>
    </message>
    <message>
        <source>1 tetrahedron inside the region was left out: it touches the others only at a vertex or an edge.</source>
        <translation>1 Tetraeder im Bereich wurde weggelassen: Es berührt die anderen nur an einem Knoten oder einer Kante.</translation>
    </message>
    <message>
        <source>%1 tetrahedra inside the region were left out: they touch the others only at a vertex or an edge.</source>
        <translation>%1 Tetraeder im Bereich wurden weggelassen: Sie berühren die anderen nur an einem Knoten oder einer Kante.</translation>
    </message>
    <message>
        <source>The values belong to cells: each point got the mean of the cells around it.</source>
        <translation>Die Werte gehören zu Zellen: Jeder Punkt bekam das Mittel der Zellen um ihn.</translation>
    </message>
    <message>
        <source>The values of the cells were brought to the points, as the mean of the cells around.</source>
        <translation>Die Werte der Zellen wurden zu den Punkten gebracht, als Mittel der Zellen ringsum.</translation>
    </message>
    <message>
        <source>All cells had inverted orientation and were corrected.</source>
        <translation>Alle Zellen hatten die umgekehrte Orientierung und wurden korrigiert.</translation>
    </message>
    <message>
        <source>What joins its points (lines, polygons) was left out: they are scattered points.</source>
        <translation>Was ihre Punkte verbindet (Linien, Polygone), wurde weggelassen: Es sind verstreute Punkte.</translation>
    </message>
    <message>
        <source>A grid with cells that are blanked out, or whose values are no numbers: an irregular mesh without them.</source>
        <translation>Ein Gitter mit ausgeblendeten Zellen oder Werten, die keine Zahlen sind: ein unregelmäßiges Netz ohne diese.</translation>
    </message>
    <message>
        <source>%1 of its parts have no &apos;%2&apos; and were left out.</source>
        <translation>%1 ihrer Teile haben kein „%2“ und wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1 of its parts are no irregular meshes and were left out.</source>
        <translation>%1 ihrer Teile sind keine unregelmäßigen Netze und wurden weggelassen.</translation>
    </message>
    <message>
        <source>It contains %1 parts; this is the one called &apos;%2&apos;. Choose another one with &apos;part&apos;.</source>
        <translation>Sie enthält %1 Teile; dies ist der namens „%2“. Einen anderen wählt „Teil“.</translation>
    </message>
    <message>
        <source>Time step %1 of %2. Choose another one with &apos;time&apos;.</source>
        <translation>Zeitschritt %1 von %2. Einen anderen wählt „Zeitschritt“.</translation>
    </message>
    <message>
        <source>%1 points whose value is no number were left out.</source>
        <translation>%1 Punkte, deren Wert keine Zahl ist, wurden weggelassen.</translation>
    </message>
    <message>
        <source>The samples were multiplied and shifted as the header of the file asks.</source>
        <translation>Die Abtastwerte wurden multipliziert und verschoben, wie der Kopf der Datei es verlangt.</translation>
    </message>
    <message>
        <source>Its 64-bit integers became floating-point numbers of 53 bits.</source>
        <translation>Aus ganzen Zahlen von 64 Bit wurden Gleitkommazahlen von 53 Bit.</translation>
    </message>
    <message>
        <source>VTK says: %1</source>
        <translation>VTK meldet: %1</translation>
    </message>
    <message>
        <source>1 cell is a vertex, line or polygon without volume and not part of the mesh.</source>
        <translation>1 Zelle ist ein Punkt, eine Linie oder ein Vieleck ohne Volumen und gehört nicht zum Netz.</translation>
    </message>
    <message>
        <source>%1 cells are a vertex, line or polygon without volume and not part of the mesh.</source>
        <translation>%1 Zellen sind Punkte, Linien oder Vielecke ohne Volumen und gehören nicht zum Netz.</translation>
    </message>
    <message>
        <source>1 cell is blanked out in the file: a hole.</source>
        <translation>1 Zelle ist in der Datei ausgeblendet: ein Loch.</translation>
    </message>
    <message>
        <source>%1 cells are blanked out in the file: a hole.</source>
        <translation>%1 Zellen sind in der Datei ausgeblendet: ein Loch.</translation>
    </message>
    <message>
        <source>1 cell has a value that is not finite and became a hole.</source>
        <translation>1 Zelle hat einen Wert, der nicht endlich ist, und wurde ein Loch.</translation>
    </message>
    <message>
        <source>%1 cells have a value that is not finite and became a hole.</source>
        <translation>%1 Zellen haben einen Wert, der nicht endlich ist, und wurden ein Loch.</translation>
    </message>
    <message>
        <source>1 cell names a corner twice, has no volume and was left out.</source>
        <translation>1 Zelle nennt eine Ecke zweimal, hat kein Volumen und wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 cells name a corner twice, have no volume and were left out.</source>
        <translation>%1 Zellen nennen eine Ecke zweimal, haben kein Volumen und wurden weggelassen.</translation>
    </message>
    <message>
        <source>1 cell without volume was left out.</source>
        <translation>1 Zelle ohne Volumen wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 cells without volume were left out.</source>
        <translation>%1 Zellen ohne Volumen wurden weggelassen.</translation>
    </message>
    <message>
        <source>1 cell had inverted orientation and was corrected.</source>
        <translation>1 Zelle hatte die umgekehrte Orientierung und wurde korrigiert.</translation>
    </message>
    <message>
        <source>%1 cells had inverted orientation and were corrected.</source>
        <translation>%1 Zellen hatten die umgekehrte Orientierung und wurden korrigiert.</translation>
    </message>
    <message>
        <source>1 point on the place of another one joined with it.</source>
        <translation>1 Punkt am Ort eines anderen wurde mit ihm vereint.</translation>
    </message>
    <message>
        <source>%1 points on the place of another one joined with it.</source>
        <translation>%1 Punkte am Ort eines anderen wurden mit ihm vereint.</translation>
    </message>
    <message>
        <source>1 place had different values and got their mean.</source>
        <translation>1 Ort hatte verschiedene Werte und bekam ihr Mittel.</translation>
    </message>
    <message>
        <source>%1 places had different values and got their mean.</source>
        <translation>%1 Orte hatten verschiedene Werte und bekamen ihr Mittel.</translation>
    </message>
    <message>
        <source>1 node in the middle of an edge or face was left out: not all cells there have them, or cells bend too much.</source>
        <translation>1 Knoten in der Mitte einer Kante oder Seite wurde weggelassen: Nicht alle Zellen dort haben ihn, oder Zellen biegen sich zu sehr.</translation>
    </message>
    <message>
        <source>%1 nodes in the middle of edges and faces were left out: not all cells there have them, or cells bend too much.</source>
        <translation>%1 Knoten in der Mitte von Kanten und Seiten wurden weggelassen: Nicht alle Zellen dort haben sie, oder Zellen biegen sich zu sehr.</translation>
    </message>
    <message>
        <source>1 cell was cut along other diagonals, because the faces are not flat.</source>
        <translation>1 Zelle wurde an anderen Diagonalen zerlegt, weil die Seiten nicht eben sind.</translation>
    </message>
    <message>
        <source>%1 cells were cut along other diagonals, because the faces are not flat.</source>
        <translation>%1 Zellen wurden an anderen Diagonalen zerlegt, weil die Seiten nicht eben sind.</translation>
    </message>
    <message>
        <source>1 cell was left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>1 Zelle wurde weggelassen: zu verwunden, um ohne neuen Punkt in Tetraeder zerlegt zu werden.</translation>
    </message>
    <message>
        <source>%1 cells were left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>%1 Zellen wurden weggelassen: zu verwunden, um ohne neuen Punkt in Tetraeder zerlegt zu werden.</translation>
    </message>
    <message>
        <source>1 tetrahedron was there twice.</source>
        <translation>1 Tetraeder war doppelt da.</translation>
    </message>
    <message>
        <source>%1 tetrahedra were there twice.</source>
        <translation>%1 Tetraeder waren doppelt da.</translation>
    </message>
    <message>
        <source>1 tetrahedron was left out where parts of the mesh touched in an edge or a point only.</source>
        <translation>1 Tetraeder wurde weggelassen, wo sich Teile des Netzes nur an einer Kante oder einem Punkt berührten.</translation>
    </message>
    <message>
        <source>%1 tetrahedra were left out where parts of the mesh touched in an edge or a point only.</source>
        <translation>%1 Tetraeder wurden weggelassen, wo sich Teile des Netzes nur an einer Kante oder einem Punkt berührten.</translation>
    </message>
    <message>
        <source>1 point is of no cell: left out.</source>
        <translation>1 Punkt gehört zu keiner Zelle: weggelassen.</translation>
    </message>
    <message>
        <source>%1 points are of no cell: left out.</source>
        <translation>%1 Punkte gehören zu keiner Zelle: weggelassen.</translation>
    </message>
    <message>
        <source>1 incomplete row was skipped.</source>
        <translation>1 unvollständige Zeile wurde übergangen.</translation>
    </message>
    <message>
        <source>%1 incomplete rows were skipped.</source>
        <translation>%1 unvollständige Zeilen wurden übergangen.</translation>
    </message>
    <message>
        <source>1 tetrahedron that is flat or inverted, one at %1</source>
        <translation>1 flaches oder invertiertes Tetraeder, bei %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that are flat or inverted, one at %2</source>
        <translation>%1 flache oder invertierte Tetraeder, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>1 tetrahedron at a face that three or more share, one at %1</source>
        <translation>1 Tetraeder an einer Seite, die drei oder mehr gemeinsam haben, bei %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra at faces that three or more share, one at %2</source>
        <translation>%1 Tetraeder an Seiten, die drei oder mehr gemeinsam haben, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>1 tetrahedron that overlaps its neighbour, one at %1</source>
        <translation>1 Tetraeder, das seinen Nachbarn überlappt, bei %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that overlap a neighbour on the same side of a face, one at %2</source>
        <translation>%1 Tetraeder, die einen Nachbarn auf derselben Seite überlappen, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>1 edge in which parts of it only touch, one at %1</source>
        <translation>1 Kante, in der sich Teile nur berühren, bei %1</translation>
    </message>
    <message>
        <source>%1 edges in which parts of it only touch, one at %2</source>
        <translation>%1 Kanten, in denen sich Teile nur berühren, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>1 point in which parts of it only touch, one at %1</source>
        <translation>1 Punkt, in dem sich Teile nur berühren, bei %1</translation>
    </message>
    <message>
        <source>%1 points in which parts of it only touch, one at %2</source>
        <translation>%1 Punkte, in denen sich Teile nur berühren, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>1 part inside another part, one at %1</source>
        <translation>1 Teil in einem anderen Teil, bei %1</translation>
    </message>
    <message>
        <source>%1 parts inside other parts, one at %2</source>
        <translation>%1 Teile in anderen Teilen, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>Not enough memory for the boundary of the mesh. Lower the accuracy of the mesh.</source>
        <translation>Der Speicher reicht nicht für die Berandung des Netzes. Verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>The mesh has too many tetrahedra for its boundary to be shown. Lower the accuracy of the mesh.</source>
        <translation>Das Netz hat zu viele Tetraeder, um seine Berandung zu zeigen. Verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be written to, so that the view cannot be kept. Make room there, or save the session.</source>
        <translation>In den Ordner „%1“ kann nicht geschrieben werden, sodass die Ansicht nicht erhalten bleibt. Schaffen Sie dort Platz, oder speichern Sie die Sitzung.</translation>
    </message>
    <message>
        <source>%1. Close other programs, or raise the limit (ulimit).</source>
        <translation>%1. Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limit (ulimit).</source>
        <translation>Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>it holds something else</source>
        <translation>er enthält etwas anderes</translation>
    </message>
    <message>
        <source>Give the model another name, or move that folder away.</source>
        <translation>Geben Sie dem Modell einen anderen Namen, oder schieben Sie jenen Ordner beiseite.</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>er ist ein Verweis</translation>
    </message>
    <message>
        <source>Give the model another name, or move that link away.</source>
        <translation>Geben Sie dem Modell einen anderen Namen, oder schieben Sie jenen Verweis beiseite.</translation>
    </message>
    <message>
        <source>Cannot make a temporary file in &apos;%1&apos;: %2. %3</source>
        <translation>In „%1“ kann keine Zwischendatei angelegt werden: %2. %3</translation>
    </message>
    <message>
        <source>A temporary file in &apos;%1&apos; cannot be used: %2. %3</source>
        <translation>Eine Zwischendatei in „%1“ kann nicht benutzt werden: %2. %3</translation>
    </message>
    <message>
        <source>The memory of this machine is not enough for this. Close other programs, or raise the limit (ulimit).</source>
        <translation>Der Speicher dieses Rechners reicht dafür nicht aus. Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>This machine can start no more threads now. Close other programs, or raise the limit (ulimit).</source>
        <translation>Dieser Rechner kann zurzeit keine weiteren Threads starten. Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>Not all plugins can be loaded now: %1. Close other programs, or raise the limit (ulimit).</source>
        <translation>Zurzeit können nicht alle Plugins geladen werden: %1. Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
</context>
<context>
    <name>Statistics</name>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>± value</source>
        <translation>± Wert</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Total vertices</source>
        <translation>Knoten insgesamt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 Knoten, %2 Tetraeder</translation>
    </message>
    <message>
        <source>Guaranteed</source>
        <translation>Garantiert</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Extraction</source>
        <translation>Extraktion</translation>
    </message>
    <message>
        <source>Preparation</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Ein Bild</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Geschnitten</translation>
    </message>
    <message>
        <source>Visibility cycles</source>
        <translation>Zyklen der Sichtfolge</translation>
    </message>
    <message>
        <source>%1, in which cells are drawn by their distance</source>
        <translation>%1, in denen die Zellen nach ihrer Entfernung gezeichnet werden</translation>
    </message>
</context>
<context>
    <name>ValueReadOut</name>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Eckpunkte</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 Eckpunkt</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyBox</name>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Error in percent of the value range</source>
        <translation>Fehler in Prozent des Wertebereichs</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyCurve</name>
    <message>
        <source>%1G</source>
        <translation>%1G</translation>
    </message>
    <message>
        <source>%1M</source>
        <translation>%1M</translation>
    </message>
    <message>
        <source>%1k</source>
        <translation>%1k</translation>
    </message>
    <message>
        <source>Error, % of the value range</source>
        <translation>Fehler, % des Wertebereichs</translation>
    </message>
    <message>
        <source>Tetrahedra against error</source>
        <translation>Tetraeder gegen Fehler</translation>
    </message>
    <message>
        <source>Number of tetrahedra needed for each error. Click, drag or use the arrow keys to choose the accuracy.</source>
        <translation>Wie viele Tetraeder jeder Fehler braucht. Klicken, ziehen oder Pfeiltasten wählen die Genauigkeit.</translation>
    </message>
    <message>
        <source>%1 tetrahedra at an error of %2</source>
        <translation>%1 Tetraeder bei einem Fehler von %2</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyPanel</name>
    <message>
        <source>%1 of all</source>
        <translation>%1 von allen</translation>
    </message>
    <message>
        <source>Error of %1 of the value range</source>
        <translation>Fehler von %1 des Wertebereichs</translation>
    </message>
    <message>
        <source>Every sample exact</source>
        <translation>Jeder Abtastwert genau</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>This model was built down to an error of %1; it has nothing finer.</source>
        <translation>Dieses Modell wurde bis zu einem Fehler von %1 gebaut; Feineres enthält es nicht.</translation>
    </message>
    <message>
        <source>of the range
± %1</source>
        <translation>des Wertebereichs
± %1</translation>
    </message>
    <message>
        <source>What the percentage means in units of the data. Of curvilinear data it holds for the error and for the warping: the distance of the mesh from the grid, in percent of the diagonal of the box around it.</source>
        <translation>Was der Prozentsatz in Einheiten der Daten heißt. Bei krummlinigen Daten gilt er für den Fehler und für die Verwerfung: den Abstand des Netzes vom Gitter, in Prozent der Diagonale des Quaders darum.</translation>
    </message>
    <message>
        <source>Bu&amp;dget</source>
        <translation>Bud&amp;get</translation>
    </message>
    <message>
        <source>The smallest mesh with this error</source>
        <translation>Das kleinste Netz mit diesem Fehler</translation>
    </message>
    <message>
        <source>The best mesh with so many tetrahedra. A focus keeps its proportion to the rest.</source>
        <translation>Das beste Netz mit so vielen Tetraedern. Ein Fokus behält sein Verhältnis zum Rest.</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Err&amp;or</source>
        <translation>Fehle&amp;r</translation>
    </message>
    <message>
        <source>± %1 in value
warping %2</source>
        <translation>± %1 im Wert
Verwerfung %2</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracySlider</name>
    <message>
        <source>Error in percent of the value range</source>
        <translation>Fehler in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>Error in percent of the value range: coarse on the left, every sample exact on the right</source>
        <translation>Fehler in Prozent des Wertebereichs: links grob, ganz rechts jeder Abtastwert genau</translation>
    </message>
</context>
<context>
    <name>tetra::AnimationPanel</name>
    <message>
        <source>&amp;Save Film…</source>
        <translation>Film spe&amp;ichern …</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>The camera goes round what is shown, or from view to view</source>
        <translation>Die Kamera fährt um das Gezeigte herum oder von Ansicht zu Ansicht</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>Pictures a second of the film</source>
        <translation>Bilder pro Sekunde des Films</translation>
    </message>
    <message>
        <source>Write it as pictures or a video</source>
        <translation>Als Bilder oder als Video schreiben</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>Ra&amp;te</source>
        <translation>&amp;Tempo</translation>
    </message>
    <message>
        <source>Around the vertical axis</source>
        <translation>Um die senkrechte Achse</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Auf und ab</translation>
    </message>
    <message>
        <source>Up and down the camera comes back to where it began, and stops at the poles</source>
        <translation>Auf und ab kommt die Kamera an ihren Anfang zurück und hält an den Polen</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to turn by, in degrees; negative the other way round</source>
        <translation>Drehwinkel in Grad; negativ anders herum</translation>
    </message>
    <message>
        <source>Pictures of the whole film</source>
        <translation>Bilder des ganzen Films</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>A&amp;chse</translation>
    </message>
    <message>
        <source>An&amp;gle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>B&amp;ilder</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>Das Bild, das gezeigt wird</translation>
    </message>
    <message>
        <source>Add two views or more.</source>
        <translation>Fügen Sie zwei oder mehr Ansichten hinzu.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 Bilder, %2</translation>
    </message>
    <message>
        <source>Kind of film</source>
        <translation>Art des Films</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Axis to turn around</source>
        <translation>Achse der Drehung</translation>
    </message>
    <message>
        <source>Angle to turn by</source>
        <translation>Drehwinkel</translation>
    </message>
    <message>
        <source>Number of frames</source>
        <translation>Zahl der Bilder</translation>
    </message>
</context>
<context>
    <name>tetra::AnnotationRows</name>
    <message>
        <source>Top left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>Unten rechts</translation>
    </message>
    <message>
        <source>Corner of the picture where it stands</source>
        <translation>Ecke des Bildes, in der es steht</translation>
    </message>
    <message>
        <source>%1: corner</source>
        <translation>%1: Ecke</translation>
    </message>
</context>
<context>
    <name>tetra::BudgetBox</name>
    <message>
        <source>Most tetrahedra</source>
        <translation>Höchstzahl der Tetraeder</translation>
    </message>
    <message>
        <source>The mesh is as good as so many tetrahedra allow</source>
        <translation>Das Netz ist so gut, wie es so viele Tetraeder erlauben</translation>
    </message>
</context>
<context>
    <name>tetra::BuildPanel</name>
    <message>
        <source>Open a dataset to build a model of it.</source>
        <translation>Öffnen Sie einen Datensatz, um sein Modell zu bauen.</translation>
    </message>
    <message>
        <source>Builder</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the model is built</source>
        <translation>Wie das Modell gebaut wird</translation>
    </message>
    <message>
        <source>B&amp;uilder</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>Model file</source>
        <translation>Modelldatei</translation>
    </message>
    <message>
        <source>The file that the model is written to</source>
        <translation>Die Datei, in die das Modell geschrieben wird</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen …</translation>
    </message>
    <message>
        <source>&amp;Model file</source>
        <translation>&amp;Modelldatei</translation>
    </message>
    <message>
        <source>Progress of the build</source>
        <translation>Fortschritt des Bauens</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Stop the build and discard what it has made</source>
        <translation>Bricht den Bau ab und verwirft das bisher Gebaute</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>Anhalten und behal&amp;ten</translation>
    </message>
    <message>
        <source>Stop the build and keep what is finished as the model, with the accuracy reached so far</source>
        <translation>Beendet den Bau; was fertig ist, wird das Modell, mit der bisher erreichten Genauigkeit</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Keeping what is finished…</source>
        <translation>Das Fertige wird behalten …</translation>
    </message>
    <message>
        <source>&amp;Build and Replace</source>
        <translation>Ba&amp;uen und ersetzen</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>Ba&amp;uen</translation>
    </message>
    <message>
        <source>This file exists; it is replaced when the build is done.</source>
        <translation>Diese Datei gibt es schon; sie wird ersetzt, wenn das Modell fertig ist.</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Beginnt …</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>Model File</source>
        <translation>Modelldatei</translation>
    </message>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelle (*.tan)</translation>
    </message>
    <message>
        <source>%1 scattered points</source>
        <translation>%1 verstreute Punkte</translation>
    </message>
    <message>
        <source>irregular mesh of %1 points, %2 tetrahedra</source>
        <translation>unregelmäßiges Netz aus %1 Punkten, %2 Tetraedern</translation>
    </message>
    <message>
        <source>curvilinear grid of %1 points, %2 cells</source>
        <translation>krummliniges Gitter mit %1 Punkten, %2 Zellen</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastwerte</translation>
    </message>
    <message>
        <source>%1, %2, values %3 to %4</source>
        <translation>%1, %2, Werte %3 bis %4</translation>
    </message>
    <message>
        <source>&amp;Import Options…</source>
        <translation>&amp;Importoptionen …</translation>
    </message>
    <message>
        <source>Read the file again with other options: other values, a part of it, fewer points</source>
        <translation>Liest die Datei mit anderen Optionen noch einmal: andere Werte, ein Ausschnitt, weniger Punkte</translation>
    </message>
    <message>
        <source>Estimated from a few thousand of the dataset&apos;s samples; it may be off by a factor of two</source>
        <translation>Aus einigen Tausend Werten des Datensatzes geschätzt; kann um den Faktor zwei abweichen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Qui&amp;ck look, error 1 %</source>
        <translation>&amp;Schneller Blick, Fehler 1 %</translation>
    </message>
    <message>
        <source>Keeps what is needed for an error of 1 % of the value range: enough for a first look</source>
        <translation>Behält, was für einen Fehler von 1 % des Wertebereichs nötig ist: genug für einen ersten Blick</translation>
    </message>
    <message>
        <source>&amp;Good, error 0.1 %</source>
        <translation>&amp;Gut, Fehler 0,1 %</translation>
    </message>
    <message>
        <source>Keeps what is needed for an error of 0.1 % of the value range: pictures can hardly be told from those of the full data</source>
        <translation>Behält, was für einen Fehler von 0,1 % des Wertebereichs nötig ist: Bilder sind von denen aller Daten kaum zu unterscheiden</translation>
    </message>
    <message>
        <source>&amp;Everything</source>
        <translation>&amp;Alles</translation>
    </message>
    <message>
        <source>Keeps every value of the dataset, so that any accuracy can be shown later</source>
        <translation>Behält jeden Wert des Datensatzes, sodass später jede Genauigkeit gezeigt werden kann</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detailgrad</translation>
    </message>
    <message>
        <source>Detail (model size, build time)</source>
        <translation>Detailgrad (Modellgröße, Bauzeit)</translation>
    </message>
</context>
<context>
    <name>tetra::Canvas</name>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
</context>
<context>
    <name>tetra::ColourButton</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Other Colour…</source>
        <translation>Andere Farbe …</translation>
    </message>
</context>
<context>
    <name>tetra::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Eingeben, was zu tun ist</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>A few letters of a command are enough. Enter does it, Esc leaves.</source>
        <translation>Ein paar Buchstaben eines Befehls genügen. Enter führt ihn aus, Esc schließt.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
</context>
<context>
    <name>tetra::EditMenu</name>
    <message>
        <source>&amp;More opaque</source>
        <translation>&amp;Deckender</translation>
    </message>
    <message>
        <source>&amp;Less opaque</source>
        <translation>Durch&amp;sichtiger</translation>
    </message>
    <message>
        <source>Swap &amp;ends</source>
        <translation>&amp;Enden vertauschen</translation>
    </message>
    <message>
        <source>Spread over all &amp;values</source>
        <translation>Über alle &amp;Werte spreizen</translation>
    </message>
    <message>
        <source>Select &amp;all points</source>
        <translation>&amp;Alle Punkte auswählen</translation>
    </message>
    <message>
        <source>&amp;Copy points</source>
        <translation>Punkte &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste points</source>
        <translation>Punkte e&amp;infügen</translation>
    </message>
    <message>
        <source>D&amp;uplicate points</source>
        <translation>Punkte &amp;verdoppeln</translation>
    </message>
    <message>
        <source>&amp;Remove points</source>
        <translation>Punkte &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Distribute values evenly</source>
        <translation>Werte &amp;gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>&amp;Flip left to right</source>
        <translation>&amp;Links und rechts vertauschen</translation>
    </message>
    <message>
        <source>&amp;Invert opacities</source>
        <translation>Deckkraft &amp;umkehren</translation>
    </message>
    <message>
        <source>Ramp from first to last</source>
        <translation>Rampe vom ersten zum letzten</translation>
    </message>
    <message>
        <source>&amp;Simplify: fewer points, same look</source>
        <translation>Ver&amp;einfachen: weniger Punkte, gleiches Aussehen</translation>
    </message>
    <message>
        <source>Add a pea&amp;k</source>
        <translation>S&amp;pitze hinzufügen</translation>
    </message>
    <message>
        <source>Ali&amp;gn</source>
        <translation>A&amp;usrichten</translation>
    </message>
    <message>
        <source>Opacities to the &amp;first</source>
        <translation>Deckkraft wie beim &amp;ersten</translation>
    </message>
    <message>
        <source>Opacities to the &amp;mean</source>
        <translation>Deckkraft im &amp;Mittel</translation>
    </message>
    <message>
        <source>Opacities to the &amp;least</source>
        <translation>Deckkraft wie beim &amp;niedrigsten</translation>
    </message>
    <message>
        <source>Opacities to the l&amp;argest</source>
        <translation>Deckkraft wie beim &amp;höchsten</translation>
    </message>
    <message>
        <source>&amp;Values of two neighbours: a step</source>
        <translation>&amp;Werte zweier Nachbarn: eine Stufe</translation>
    </message>
    <message>
        <source>Make a gr&amp;oup</source>
        <translation>&amp;Gruppe bilden</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Gruppe auswählen</translation>
    </message>
    <message>
        <source>&amp;No group</source>
        <translation>&amp;Keine Gruppe</translation>
    </message>
    <message>
        <source>When points meet neighbouri&amp;ng points</source>
        <translation>Beim Treffen auf Nachbarpu&amp;nkte</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Push them along</source>
        <translation>Mit&amp;schieben</translation>
    </message>
    <message>
        <source>Move p&amp;ast them</source>
        <translation>&amp;Überholen</translation>
    </message>
    <message>
        <source>Mas&amp;k: show some values only</source>
        <translation>&amp;Maske: nur einige Werte zeigen</translation>
    </message>
    <message>
        <source>Add an iso&amp;value</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Group &amp;%1</source>
        <translation>Gruppe &amp;%1</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>&amp;Breiter</translation>
    </message>
    <message>
        <source>Na&amp;rrower</source>
        <translation>S&amp;chmaler</translation>
    </message>
    <message>
        <source>Add a &amp;point</source>
        <translation>&amp;Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add an &amp;isovalue</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Cl&amp;ear mark</source>
        <translation>&amp;Markierung löschen</translation>
    </message>
    <message>
        <source>Follow the logarit&amp;hm of the value</source>
        <translation>Dem &amp;Logarithmus des Wertes folgen</translation>
    </message>
    <message>
        <source>From &amp;the picked value</source>
        <translation>Vom &amp;gewählten Wert</translation>
    </message>
</context>
<context>
    <name>tetra::EmptyPage</name>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Datensatz oder Modell öffnen</translation>
    </message>
    <message>
        <source>Drop a file: a dataset (a volume, a grid, a mesh or points), a .tan model or a session. TAn shows large data at any accuracy, with a known error.</source>
        <translation>Legen Sie eine Datei ab: einen Datensatz (ein Volumen, ein Gitter, ein Netz oder Punkte), ein .tan-Modell oder eine Sitzung. TAn zeigt große Daten in jeder Genauigkeit, mit bekanntem Fehler.</translation>
    </message>
    <message>
        <source>Open a dataset, a model or a session (Ctrl+O)</source>
        <translation>Einen Datensatz, ein Modell oder eine Sitzung öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>Or try a sample</source>
        <translation>Oder ein Beispiel ansehen</translation>
    </message>
    <message>
        <source>Samples are computed when you choose one; nothing is downloaded.</source>
        <translation>Beispiele werden berechnet, wenn Sie eines wählen; nichts wird heruntergeladen.</translation>
    </message>
</context>
<context>
    <name>tetra::FilmDialog</name>
    <message>
        <source>Numbered PNG pictures</source>
        <translation>Nummerierte PNG-Bilder</translation>
    </message>
    <message>
        <source>MP4 video (H.264)</source>
        <translation>MP4-Video (H.264)</translation>
    </message>
    <message>
        <source>WebM video (VP9)</source>
        <translation>WebM-Video (VP9)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen …</translation>
    </message>
    <message>
        <source>Save Film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Videos can be made where the program ffmpeg is installed</source>
        <translation>Videos gibt es, wo das Programm ffmpeg installiert ist</translation>
    </message>
    <message>
        <source>Videos are made by %1</source>
        <translation>Videos macht %1</translation>
    </message>
    <message>
        <source>The video, or the name that numbers are added to</source>
        <translation>Das Video oder der Name, an den Nummern gehängt werden</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>Fil&amp;e</source>
        <translation>Dat&amp;ei</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>A film that is being written goes on</source>
        <translation>Ein Film, der geschrieben wird, läuft weiter</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>It has no frames yet: add two views or more in the panel Animation.</source>
        <translation>Er hat noch keine Bilder: Fügen Sie im Bereich Animation zwei oder mehr Ansichten hinzu.</translation>
    </message>
    <message>
        <source>%1; writing takes about %2</source>
        <translation>%1; das Schreiben dauert etwa %2</translation>
    </message>
    <message>
        <source>%1, …</source>
        <translation>%1, …</translation>
    </message>
    <message>
        <source>&amp;Replace and Save</source>
        <translation>E&amp;rsetzen und speichern</translation>
    </message>
    <message>
        <source>Beginning…</source>
        <translation>Beginnt …</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, noch etwa %2</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 Bilder, %2</translation>
    </message>
    <message>
        <source>Files of this name are there already and will be replaced: %1.</source>
        <translation>Dateien dieses Namens gibt es schon, sie werden ersetzt: %1.</translation>
    </message>
</context>
<context>
    <name>tetra::FocusPanel</name>
    <message>
        <source>A part of the domain with an error of its own. Choose a shape, then drag its handles in the picture; a double click on a surface brings the focus there.</source>
        <translation>Ein Teil des Gebiets mit eigenem Fehler. Eine Form wählen, dann die Griffe im Bild ziehen; ein Doppelklick auf eine Fläche holt den Fokus dorthin.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>The same error everywhere</source>
        <translation>Überall derselbe Fehler</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>A box with an error of its own (B)</source>
        <translation>Ein Quader mit eigenem Fehler (B)</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>A sphere with an error of its own (F)</source>
        <translation>Eine Kugel mit eigenem Fehler (F)</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>&amp;Mitte</translation>
    </message>
    <message>
        <source>Centre of the focus, in the coordinates of the data</source>
        <translation>Mitte des Fokus, in den Koordinaten der Daten</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Edges of the box, in data units</source>
        <translation>Kanten des Quaders, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>Radius of the sphere</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>Radius of the sphere, in data units</source>
        <translation>Radius der Kugel, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>The distance over which the error grows from that in the focus to that outside, in data units; 0 is a sharp border</source>
        <translation>Die Strecke, auf der der Fehler von dem im Fokus auf den außerhalb wächst, in Einheiten der Daten; 0 ist eine scharfe Grenze</translation>
    </message>
    <message>
        <source>Error in the focus</source>
        <translation>Fehler im Fokus</translation>
    </message>
    <message>
        <source>Error in the focus, in percent of the value range</source>
        <translation>Fehler im Fokus in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>Move the focus to what the camera looks at (C)</source>
        <translation>Den Fokus dorthin holen, wohin die Kamera blickt (C)</translation>
    </message>
    <message>
        <source>Place, size, error and fall-off as they were at first</source>
        <translation>Ort, Größe, Fehler und Übergang wie am Anfang</translation>
    </message>
    <message>
        <source>Outside %1, as chosen under Accuracy.</source>
        <translation>Außerhalb %1, wie unter Genauigkeit gewählt.</translation>
    </message>
    <message>
        <source>Between %1 and %2 tetrahedra.</source>
        <translation>Zwischen %1 und %2 Tetraedern.</translation>
    </message>
    <message>
        <source>Rad&amp;ius</source>
        <translation>Rad&amp;ius</translation>
    </message>
    <message>
        <source>Error i&amp;nside</source>
        <translation>Fehler i&amp;nnen</translation>
    </message>
    <message>
        <source>Fa&amp;ll-off</source>
        <translation>&amp;Übergang</translation>
    </message>
    <message>
        <source>&amp;Move to Centre of View</source>
        <translation>&amp;In die Bildmitte</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>With the budget the error outside is %1 times this one.</source>
        <translation>Mit dem Budget ist der Fehler außerhalb das %1-fache davon.</translation>
    </message>
    <message>
        <source>A focus is not coarser than what is around it, so it gets the same error.</source>
        <translation>Ein Fokus ist nicht gröber als seine Umgebung, also erhält er denselben Fehler.</translation>
    </message>
    <message>
        <source>A focus is not coarser than what is around it, so it gets %1.</source>
        <translation>Ein Fokus ist nicht gröber als seine Umgebung, also erhält er %1.</translation>
    </message>
</context>
<context>
    <name>tetra::HistogramView</name>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>How often the values of the mesh that is shown occur, on a logarithmic scale; from the least to the largest value, in the units of the data</source>
        <translation>Wie oft die Werte des gezeigten Netzes vorkommen, logarithmisch, vom kleinsten bis zum größten Wert, in den Einheiten der Daten</translation>
    </message>
</context>
<context>
    <name>tetra::ImportDialog</name>
    <message>
        <source>&amp;Read</source>
        <translation>&amp;Lesen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Reader</source>
        <translation>Leser</translation>
    </message>
    <message>
        <source>Reader used for this file</source>
        <translation>Leser für diese Datei</translation>
    </message>
    <message>
        <source>R&amp;eader</source>
        <translation>L&amp;eser</translation>
    </message>
    <message>
        <source>Import options</source>
        <translation>Importoptionen</translation>
    </message>
    <message>
        <source>Subset</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Layouts that fit</source>
        <translation>Passende Anordnungen</translation>
    </message>
    <message>
        <source>Sizes and types that would fill the file exactly, the likeliest first</source>
        <translation>Größen und Typen, die die Datei genau füllen würden, die wahrscheinlichsten zuerst</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Fortschritt des Lesens</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>%1, %2 bytes</source>
        <translation>%1, %2 Bytes</translation>
    </message>
    <message>
        <source>None is known</source>
        <translation>Keine bekannt</translation>
    </message>
    <message>
        <source>Give the number of points along x, y and z, as in 64x64x32.</source>
        <translation>Geben Sie die Zahl der Punkte entlang x, y und z an, wie in 64x64x32.</translation>
    </message>
    <message>
        <source>Size check</source>
        <translation>Größenprüfung</translation>
    </message>
    <message>
        <source>&amp;Suggestion</source>
        <translation>&amp;Vorschlag</translation>
    </message>
    <message>
        <source>Open with these options</source>
        <translation>Öffnet den Datensatz mit diesen Optionen</translation>
    </message>
    <message>
        <source>Stops reading, or closes this window</source>
        <translation>Bricht das Lesen ab oder schließt dieses Fenster</translation>
    </message>
    <message>
        <source>An upper bound; a model with less detail takes less.</source>
        <translation>Eine obere Schranke; ein Modell mit geringerem Detailgrad braucht weniger.</translation>
    </message>
</context>
<context>
    <name>tetra::ImportRegion</name>
    <message>
        <source>&amp;All Points</source>
        <translation>&amp;Alle Punkte</translation>
    </message>
    <message>
        <source>Only a &amp;box in space</source>
        <translation>Nur ein &amp;Quader im Raum</translation>
    </message>
    <message>
        <source>Takes every point of the whole dataset</source>
        <translation>Nimmt jeden Punkt des ganzen Datensatzes</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erster</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzter</translation>
    </message>
    <message>
        <source>Stride</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>First point along %1</source>
        <translation>Erster Punkt entlang %1</translation>
    </message>
    <message>
        <source>The first point that is taken, counted from 0</source>
        <translation>Der erste Punkt, der genommen wird, von 0 an gezählt</translation>
    </message>
    <message>
        <source>Last point along %1</source>
        <translation>Letzter Punkt entlang %1</translation>
    </message>
    <message>
        <source>The last point that is taken, counted from 0</source>
        <translation>Der letzte Punkt, der genommen wird, von 0 an gezählt</translation>
    </message>
    <message>
        <source>Stride along %1</source>
        <translation>Schrittweite entlang %1</translation>
    </message>
    <message>
        <source>Keep every n-th point</source>
        <translation>Behält jeden n-ten Punkt</translation>
    </message>
    <message>
        <source>Takes only what lies in a box; of irregular meshes whole tetrahedra</source>
        <translation>Nimmt nur, was in einem Quader liegt; von unregelmäßigen Netzen ganze Tetraeder</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>Bis %1</translation>
    </message>
    <message>
        <source>A corner of the box, in the coordinates of the data</source>
        <translation>Eine Ecke des Quaders, in den Koordinaten der Daten</translation>
    </message>
</context>
<context>
    <name>tetra::IsovaluePanel</name>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>No isovalue: there is nothing to draw but the outline.</source>
        <translation>Kein Isowert: Außer dem Umriss ist nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Add an isosurface at another value (Ctrl+I)</source>
        <translation>Fügt eine Isofläche bei einem weiteren Wert hinzu (Strg+I)</translation>
    </message>
</context>
<context>
    <name>tetra::IsovalueRow</name>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Isovalue, in the units of the data: %1 to %2</source>
        <translation>Isowert, in den Einheiten der Daten: %1 bis %2</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity in percent; below 100 % what lies behind shows through</source>
        <translation>Deckkraft in Prozent; unter 100 % scheint durch, was dahinter liegt</translation>
    </message>
    <message>
        <source>Show this isosurface</source>
        <translation>Diese Isofläche zeigen</translation>
    </message>
    <message>
        <source>Remove this isovalue (Del)</source>
        <translation>Diesen Isowert entfernen (Entf)</translation>
    </message>
    <message>
        <source>Remove this isovalue</source>
        <translation>Diesen Isowert entfernen</translation>
    </message>
</context>
<context>
    <name>tetra::KeepSession</name>
    <message>
        <source>Save Session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sitzungen (*.tansession)</translation>
    </message>
    <message>
        <source>TAn ended unexpectedly while %1 was open. How it was seen can be restored.</source>
        <translation>TAn wurde unerwartet beendet, während %1 geöffnet war. Die Ansicht kann wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>%1 holds the view that it shows, which can be restored.</source>
        <translation>%1 enthält die Ansicht, die es zeigt; sie kann wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>Saved automatically on %1. Model: %2</source>
        <translation>Automatisch gesichert am %1. Modell: %2</translation>
    </message>
</context>
<context>
    <name>tetra::KeyFrameList</name>
    <message>
        <source>%1°, %2° at %3</source>
        <translation>%1°, %2° bei %3</translation>
    </message>
    <message>
        <source>%1, %2 tetrahedra</source>
        <translation>%1, %2 Tetraeder</translation>
    </message>
    <message>
        <source>%1, error %2</source>
        <translation>%1, Fehler %2</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Enter shows a key frame, Delete removes it, Alt with an arrow moves it</source>
        <translation>Eingabe zeigt ein Schlüsselbild, Entf entfernt es, Alt mit einem Pfeil verschiebt es</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>&amp;Add View</source>
        <translation>Ansicht hin&amp;zufügen</translation>
    </message>
    <message>
        <source>Add what is seen now as the next key frame</source>
        <translation>Was jetzt zu sehen ist, als nächstes Schlüsselbild hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Put what is seen now in the place of this key frame</source>
        <translation>Was jetzt zu sehen ist, an die Stelle dieses Schlüsselbilds setzen</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>Zei&amp;gen</translation>
    </message>
    <message>
        <source>Show this key frame (Enter)</source>
        <translation>Dieses Schlüsselbild zeigen (Eingabe)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>E&amp;ntfernen</translation>
    </message>
    <message>
        <source>Remove this key frame (Delete)</source>
        <translation>Dieses Schlüsselbild entfernen (Entf)</translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation>&amp;Früher</translation>
    </message>
    <message>
        <source>Exchange it with the key frame before it (Alt+Up)</source>
        <translation>Mit dem Schlüsselbild davor tauschen (Alt+Auf)</translation>
    </message>
    <message>
        <source>La&amp;ter</source>
        <translation>S&amp;päter</translation>
    </message>
    <message>
        <source>Exchange it with the key frame after it (Alt+Down)</source>
        <translation>Mit dem Schlüsselbild danach tauschen (Alt+Ab)</translation>
    </message>
    <message>
        <source>Show Key Frame</source>
        <translation>Schlüsselbild zeigen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Azimuth and elevation, distance in the units of the data, accuracy</source>
        <translation>Azimut und Höhe, Abstand in den Einheiten der Daten, Genauigkeit</translation>
    </message>
</context>
<context>
    <name>tetra::Leaving</name>
    <message>
        <source>%1 % is done, about %2 are left.</source>
        <translation>%1 % sind fertig, es dauert noch etwa %2.</translation>
    </message>
    <message>
        <source>%1 % is done.</source>
        <translation>%1 % sind fertig.</translation>
    </message>
    <message>
        <source>It can continue in the background.</source>
        <translation>Das kann im Hintergrund weitergehen.</translation>
    </message>
    <message>
        <source>If you stop now, you can keep what is finished as %1, a model of lower accuracy.</source>
        <translation>Wenn Sie jetzt anhalten, können Sie das Fertige als %1 behalten, ein Modell geringerer Genauigkeit.</translation>
    </message>
    <message>
        <source>Nothing of it can be kept yet.</source>
        <translation>Behalten werden kann davon noch nichts.</translation>
    </message>
    <message>
        <source>Build in Progress</source>
        <translation>Modell im Bau</translation>
    </message>
    <message>
        <source>The model of %1 is still being built.</source>
        <translation>Das Modell von %1 wird noch gebaut.</translation>
    </message>
    <message>
        <source>&amp;Continue Building</source>
        <translation>&amp;Weiterbauen</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>Anhalten und behal&amp;ten</translation>
    </message>
    <message>
        <source>&amp;Discard Build</source>
        <translation>&amp;Bau verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>If you stop it, nothing of it is kept.</source>
        <translation>Wenn Sie ihn anhalten, bleibt nichts davon.</translation>
    </message>
    <message>
        <source>Film in Progress</source>
        <translation>Film in Arbeit</translation>
    </message>
    <message>
        <source>The film %1 is still being written.</source>
        <translation>Der Film %1 wird noch geschrieben.</translation>
    </message>
    <message>
        <source>&amp;Continue Writing</source>
        <translation>&amp;Weiterschreiben</translation>
    </message>
    <message>
        <source>&amp;Discard Film</source>
        <translation>&amp;Film verwerfen</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The session %1 has unsaved changes.</source>
        <translation>Die Sitzung %1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Your changes will be lost if you do not save them.</source>
        <translation>Ihre Änderungen gehen verloren, wenn Sie sie nicht speichern.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Es wird gespeichert</translation>
    </message>
    <message>
        <source>A file is still being saved.</source>
        <translation>Eine Datei wird noch gespeichert.</translation>
    </message>
    <message>
        <source>TAn will quit when it is done.</source>
        <translation>TAn wird beendet, sobald das getan ist.</translation>
    </message>
    <message>
        <source>&amp;Do Not Quit</source>
        <translation>&amp;Nicht beenden</translation>
    </message>
    <message>
        <source>&amp;Quit Without Saving</source>
        <translation>Ohne Speichern &amp;beenden</translation>
    </message>
</context>
<context>
    <name>tetra::LostOffers</name>
    <message>
        <source>Sessions to restore</source>
        <translation>Sitzungen zum Wiederherstellen</translation>
    </message>
    <message>
        <source>TAn ended unexpectedly while %1 was open.</source>
        <translation>TAn endete unerwartet, während %1 geöffnet war.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Open the model with its view restored. The saved view is kept until that has worked.</source>
        <translation>Öffnet das Modell in seiner letzten Ansicht. Die gesicherte Ansicht bleibt, bis das gelungen ist.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>Discard the saved view (the model file is kept)</source>
        <translation>Verwirft die gesicherte Ansicht (die Modelldatei bleibt)</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>%1 verwerfen</translation>
    </message>
</context>
<context>
    <name>tetra::MainWindow</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>One file can be open at a time; of those dropped, %1 was opened.</source>
        <translation>Es kann nur eine Datei zugleich offen sein; von den abgelegten wurde %1 geöffnet.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>TAn</source>
        <translation>TAn</translation>
    </message>
    <message>
        <source>Dataset loaded. Choose options on the left and press Build to view it.</source>
        <translation>Der Datensatz ist geladen. Wählen Sie links die Optionen und drücken Sie „Bauen“, um ihn anzusehen.</translation>
    </message>
    <message>
        <source>About TAn</source>
        <translation>Über TAn</translation>
    </message>
    <message>
        <source>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: multiresolution volume data with a known error.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: Volumendaten in vielen Auflösungen mit bekanntem Fehler.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Wird gespeichert</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>Drawing the film</source>
        <translation>Der Film wird gezeichnet</translation>
    </message>
    <message>
        <source>Picture copied, %1 × %2 pixels</source>
        <translation>Bild kopiert, %1 × %2 Pixel</translation>
    </message>
    <message>
        <source>Drawing the picture, %1 more waiting</source>
        <translation>Das Bild wird gezeichnet, %1 weitere warten</translation>
    </message>
    <message>
        <source>Reset View</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>The model %1 is built.</source>
        <translation>Das Modell %1 ist fertig gebaut.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>%1[*] – TAn</source>
        <translation>%1[*] – TAn</translation>
    </message>
    <message>
        <source>Its model is being built. The panel on the left shows the progress.</source>
        <translation>Sein Modell wird gebaut. Das Feld links zeigt den Fortschritt.</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Das Beispiel wird erzeugt</translation>
    </message>
    <message>
        <source>%1 is not built yet. The picture still shows %2.</source>
        <translation>%1 ist noch nicht gebaut. Das Bild zeigt noch %2.</translation>
    </message>
    <message>
        <source>The picture is not of the present settings, which could not be shown.</source>
        <translation>Das Bild gehört nicht zu den jetzigen Einstellungen: Die ließen sich nicht darstellen.</translation>
    </message>
</context>
<context>
    <name>tetra::MessageBar</name>
    <message>
        <source>Show or hide the older messages</source>
        <translation>Zeigt oder verbirgt die älteren Meldungen</translation>
    </message>
    <message>
        <source>Close All</source>
        <translation>Alle schließen</translation>
    </message>
    <message>
        <source>Dismiss all messages</source>
        <translation>Schließt alle Meldungen</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>Weniger zeigen</translation>
    </message>
    <message>
        <source>Show %1 more</source>
        <translation>%1 weitere zeigen</translation>
    </message>
</context>
<context>
    <name>tetra::MessageRow</name>
    <message>
        <source>Dismiss this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
</context>
<context>
    <name>tetra::ModeActions</name>
    <message>
        <source>Show %1 (%2)</source>
        <translation>%1 zeigen (%2)</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
</context>
<context>
    <name>tetra::Opening</name>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelle (*.tan)</translation>
    </message>
    <message>
        <source>All that can be opened (%1)</source>
        <translation>Alles, was sich öffnen lässt (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sitzungen (*.tansession)</translation>
    </message>
    <message>
        <source>The model %1 is another one than when the session was saved: it was built anew, or replaced. It is shown as the session says, as far as that fits.</source>
        <translation>Das Modell %1 ist ein anderes als beim Speichern der Sitzung: Es wurde neu gebaut oder ersetzt. Es wird so gezeigt, wie die Sitzung sagt, soweit das passt.</translation>
    </message>
    <message>
        <source>Pictures with their sessions (*.png)</source>
        <translation>Bilder mit ihren Sitzungen (*.png)</translation>
    </message>
</context>
<context>
    <name>tetra::OrientationActions</name>
    <message>
        <source>Turn Upside Down</source>
        <translation>Auf den Kopf stellen</translation>
    </message>
    <message>
        <source>Let the axis that points up point down</source>
        <translation>Die Achse, die nach oben zeigt, nach unten zeigen lassen</translation>
    </message>
    <message>
        <source>Roll Clockwise</source>
        <translation>Im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the picture by 90° clockwise</source>
        <translation>Das Bild um 90° im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Roll Anticlockwise</source>
        <translation>Gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the picture by 90° anticlockwise</source>
        <translation>Das Bild um 90° gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Waagrecht ausrichten</translation>
    </message>
    <message>
        <source>Take the roll away: the axis that points up is upright</source>
        <translation>Die Neigung aufheben: die Achse, die nach oben zeigt, steht aufrecht</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging turns the model freely, in any direction, instead of around the up axis</source>
        <translation>Ziehen dreht das Modell frei in jede Richtung, statt um die Achse, die nach oben zeigt</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Show the model with this axis upright</source>
        <translation>Das Modell so zeigen, dass diese Achse senkrecht steht</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>The picture is not rolled</source>
        <translation>Das Bild ist nicht geneigt</translation>
    </message>
</context>
<context>
    <name>tetra::ParameterForm</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>for example %1</source>
        <translation>zum Beispiel %1</translation>
    </message>
</context>
<context>
    <name>tetra::PickActions</name>
    <message>
        <source>&amp;Pick</source>
        <translation>W&amp;ählen</translation>
    </message>
    <message>
        <source>Pick the value at the pointer, or in the middle of the picture</source>
        <translation>Wählt den Wert am Zeiger oder in der Bildmitte</translation>
    </message>
    <message>
        <source>&amp;Isosurface at This Value</source>
        <translation>&amp;Isofläche bei diesem Wert</translation>
    </message>
    <message>
        <source>Add an isosurface of the picked value</source>
        <translation>Fügt eine Isofläche des gewählten Wertes hinzu</translation>
    </message>
    <message>
        <source>Add &amp;Transfer-Function Point</source>
        <translation>Punkt der &amp;Transferfunktion hinzufügen</translation>
    </message>
    <message>
        <source>Add a point to the transfer function at the picked value</source>
        <translation>Fügt der Transferfunktion beim gewählten Wert einen Punkt hinzu</translation>
    </message>
    <message>
        <source>&amp;Clear Mark</source>
        <translation>&amp;Markierung löschen</translation>
    </message>
    <message>
        <source>Clear the picked value</source>
        <translation>Entfernt den gewählten Wert</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>Click a place in the picture first, or pick one</source>
        <translation>Erst eine Stelle im Bild anklicken oder wählen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>tetra::PictureDialog</name>
    <message>
        <source>Store &amp;how it was made in the file</source>
        <translation>&amp;Entstehung in der Datei vermerken</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Program, model, accuracy, camera, transfer function and isovalues, so that the picture can be made again: opening it offers its view</source>
        <translation>Programm, Modell, Genauigkeit, Kamera, Transferfunktion und Isowerte, sodass das Bild noch einmal gemacht werden kann: Beim Öffnen wird seine Ansicht angeboten</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>Put it on the clipboard</source>
        <translation>In die Zwischenablage legen</translation>
    </message>
</context>
<context>
    <name>tetra::PictureForm</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Print resolution in pixels per inch; the number of pixels does not change</source>
        <translation>Druckauflösung in Pixeln pro Zoll; die Zahl der Pixel ändert sich nicht</translation>
    </message>
    <message>
        <source>Trans&amp;parent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Twice the screen size</source>
        <translation>Doppelte Bildschirmgröße</translation>
    </message>
    <message>
        <source>HD</source>
        <translation>HD</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Annotations and lines take as much of the picture as they do of the view</source>
        <translation>Beschriftung und Linien nehmen so viel vom Bild ein wie von der Ansicht</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Only what is shown, to be laid over something else</source>
        <translation>Nur das Gezeigte, um es über anderes zu legen</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>%1 × %2 cm</source>
        <translation>%1 × %2 cm</translation>
    </message>
    <message>
        <source>Pixe&amp;ls</source>
        <translation>Pi&amp;xel</translation>
    </message>
    <message>
        <source>Pri&amp;nt resolution</source>
        <translation>Dr&amp;uckauflösung</translation>
    </message>
</context>
<context>
    <name>tetra::PluginWindow</name>
    <message>
        <source>Plugins</source>
        <translation>Plugins</translation>
    </message>
    <message>
        <source>Plugin</source>
        <translation>Plugin</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Looked for in: %1</source>
        <translation>Gesucht in: %1</translation>
    </message>
    <message>
        <source>The plugin %1 cannot be used. %2</source>
        <translation>Das Plugin %1 kann nicht benutzt werden. %2</translation>
    </message>
    <message>
        <source>What was found, and why something is not used. Space switches a plugin on or off.</source>
        <translation>Was gefunden wurde, und warum etwas nicht benutzt wird. Die Leertaste schaltet ein Plugin ein oder aus.</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Changes take effect when TAn is restarted.</source>
        <translation>Änderungen gelten ab dem nächsten Start von TAn.</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy for a bug report</source>
        <translation>Für einen Fehlerbericht kopieren</translation>
    </message>
</context>
<context>
    <name>tetra::PointNumbers</name>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Value of what is selected, in the units of the data; selected points move together</source>
        <translation>Wert des Ausgewählten in den Einheiten der Daten; ausgewählte Punkte bewegen sich gemeinsam</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the selected points, in percent of the light that a unit distance takes away</source>
        <translation>Deckkraft der ausgewählten Punkte in Prozent des Lichts, das eine Einheitslänge wegnimmt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Colour of what is selected</source>
        <translation>Farbe des Ausgewählten</translation>
    </message>
    <message>
        <source>Unit distance</source>
        <translation>Einheitslänge</translation>
    </message>
    <message>
        <source>The thickness, in the units of the data, that a layer must have for the opacities to hold: less makes everything denser</source>
        <translation>Die Dicke, in den Einheiten der Daten, bei der eine Schicht die Deckkraft hat: weniger macht alles dichter</translation>
    </message>
    <message>
        <source>Val&amp;ue</source>
        <translation>&amp;Wert</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>&amp;Deckkraft</translation>
    </message>
    <message>
        <source>U&amp;nit distance</source>
        <translation>Ein&amp;heitslänge</translation>
    </message>
</context>
<context>
    <name>tetra::PointTable</name>
    <message>
        <source>Points of the transfer function</source>
        <translation>Punkte der Transferfunktion</translation>
    </message>
    <message>
        <source>Double click or F2 edits a cell; Del removes the selected points</source>
        <translation>Doppelklick oder F2 bearbeitet eine Zelle; Entf entfernt die ausgewählten Punkte</translation>
    </message>
</context>
<context>
    <name>tetra::PointTableModel</name>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Opacity, %</source>
        <translation>Deckkraft, %</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>In the units of the data</source>
        <translation>In den Einheiten der Daten</translation>
    </message>
    <message>
        <source>Fraction absorbed per unit distance</source>
        <translation>Anteil, der je Einheitslänge absorbiert wird</translation>
    </message>
    <message>
        <source>As a name or as #rrggbb</source>
        <translation>Als Name oder als #rrggbb</translation>
    </message>
    <message>
        <source>0 to 9, or empty</source>
        <translation>0 bis 9, oder leer</translation>
    </message>
</context>
<context>
    <name>tetra::PresetPopup</name>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>Als Vorlage &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search for a preset</source>
        <translation>Nach einer Vorlage suchen</translation>
    </message>
    <message>
        <source>What to take of a preset</source>
        <translation>Was von einer Vorlage übernommen wird</translation>
    </message>
    <message>
        <source>Colours and opacities</source>
        <translation>Farben und Deckkraft</translation>
    </message>
    <message>
        <source>Colours alone</source>
        <translation>Nur die Farben</translation>
    </message>
    <message>
        <source>Opacities alone</source>
        <translation>Nur die Deckkraft</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Keep the transfer function as it is now, for this and for other models</source>
        <translation>Die Transferfunktion, wie sie jetzt ist, für dieses und andere Modelle behalten</translation>
    </message>
    <message>
        <source>Delete the chosen preset, if it is one of your own</source>
        <translation>Die gewählte Vorlage löschen, wenn es eine eigene ist</translation>
    </message>
    <message>
        <source>One of your own</source>
        <translation>Eine eigene</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Als Vorlage speichern</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>Name der Vorlage:</translation>
    </message>
</context>
<context>
    <name>tetra::RegionActions</name>
    <message>
        <source>Focus: &amp;Sphere</source>
        <translation>Fokus: &amp;Kugel</translation>
    </message>
    <message>
        <source>More accurate in a sphere</source>
        <translation>Genauer in einer Kugel</translation>
    </message>
    <message>
        <source>Focus: &amp;Box</source>
        <translation>Fokus: &amp;Quader</translation>
    </message>
    <message>
        <source>More accurate in a box</source>
        <translation>Genauer in einem Quader</translation>
    </message>
    <message>
        <source>Focus to &amp;Centre of View</source>
        <translation>Fokus zur Bild&amp;mitte</translation>
    </message>
    <message>
        <source>Move the focus to what the camera looks at</source>
        <translation>Den Fokus dorthin holen, wohin die Kamera blickt</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>Show the part of the domain in a box only</source>
        <translation>Nur den Teil des Gebiets in einem Quader zeigen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Switch on a focus first</source>
        <translation>Erst einen Fokus einschalten</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
</context>
<context>
    <name>tetra::RegionPanel</name>
    <message>
        <source>Only a &amp;window</source>
        <translation>Nur ein &amp;Fenster</translation>
    </message>
    <message>
        <source>Show the part of the domain in a box only (W)</source>
        <translation>Nur den Teil des Gebiets in einem Quader zeigen (W)</translation>
    </message>
    <message>
        <source>Where the window ends, in the coordinates of the data</source>
        <translation>Wo das Fenster endet, in den Koordinaten der Daten</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>B&amp;is</translation>
    </message>
    <message>
        <source>Cut exactly</source>
        <translation>Genau abschneiden</translation>
    </message>
    <message>
        <source>Keep tetrahedra that touch it</source>
        <translation>Berührende Tetraeder behalten</translation>
    </message>
    <message>
        <source>Keep tetrahedra inside</source>
        <translation>Nur Tetraeder innerhalb</translation>
    </message>
    <message>
        <source>Tetrahedra at the border</source>
        <translation>Tetraeder am Rand</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Rand</translation>
    </message>
    <message>
        <source>Make the window as large as the domain</source>
        <translation>Das Fenster so groß machen wie das Gebiet</translation>
    </message>
    <message>
        <source>In the units of the data: %1 to %2</source>
        <translation>In der Einheit der Daten: %1 bis %2</translation>
    </message>
    <message>
        <source>Smallest value</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Largest value</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>&amp;Limit to a range of values</source>
        <translation>Auf einen Wertebereich &amp;beschränken</translation>
    </message>
    <message>
        <source>Fro&amp;m</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>&amp;Reset to Whole Domain</source>
        <translation>Auf das ganze Gebiet zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>&amp;Smallest</source>
        <translation>&amp;Kleinster</translation>
    </message>
    <message>
        <source>&amp;Largest</source>
        <translation>&amp;Größter</translation>
    </message>
    <message>
        <source>Show only tetrahedra that can contain a value of a range. Isosurfaces of other values are not seen, or only in part.</source>
        <translation>Nur Tetraeder zeigen, die einen Wert eines Bereichs enthalten können. Isoflächen anderer Werte sind nicht oder nur teilweise zu sehen.</translation>
    </message>
    <message>
        <source>How the window ends: tetrahedra at its border are cut exactly there, or kept or left out as a whole</source>
        <translation>Wie das Fenster endet: Tetraeder an seiner Grenze werden genau dort geschnitten oder ganz behalten oder ganz weggelassen</translation>
    </message>
</context>
<context>
    <name>tetra::RenderingPanel</name>
    <message>
        <source>What is shown of the data</source>
        <translation>Was von den Daten gezeigt wird</translation>
    </message>
    <message>
        <source>Rendering mode</source>
        <translation>Darstellungsart</translation>
    </message>
    <message>
        <source>Automatic (%1 frames/s)</source>
        <translation>Automatisch (%1 Bilder/s)</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>The frame rate to keep while something moves. If the machine is too slow, frames are drawn smaller and with fewer tetrahedra; the picture at rest is always complete.</source>
        <translation>Die Bildrate, die in Bewegung gehalten wird. Ist der Rechner zu langsam, werden die Bilder kleiner und aus weniger Tetraedern gezeichnet; das ruhende Bild ist immer vollständig.</translation>
    </message>
    <message>
        <source>Frame rate while moving</source>
        <translation>Bildrate in Bewegung</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>While movin&amp;g</source>
        <translation>In Bewe&amp;gung</translation>
    </message>
</context>
<context>
    <name>tetra::SceneService</name>
    <message>
        <source>No renderer plugin could be loaded, so there is no way to show a model. %1</source>
        <translation>Kein Plugin zur Darstellung konnte geladen werden; so lässt sich kein Modell zeigen. %1</translation>
    </message>
</context>
<context>
    <name>tetra::SlicePreview</name>
    <message>
        <source>Preview of a layer</source>
        <translation>Vorschau einer Schicht</translation>
    </message>
    <message>
        <source>Axis of the layers</source>
        <translation>Achse der Schichten</translation>
    </message>
    <message>
        <source>The axis across which the layer lies</source>
        <translation>Die Achse, quer zu der die Schicht liegt</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>Quer zu %1</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>The layer that is shown, counted from 0</source>
        <translation>Die gezeigte Schicht, von 0 an gezählt</translation>
    </message>
    <message>
        <source>No preview: the layout is incomplete</source>
        <translation>Keine Vorschau: Die Anordnung ist unvollständig</translation>
    </message>
    <message>
        <source>%1 to the right, %2 up; black %3, white %4</source>
        <translation>%1 nach rechts, %2 nach oben; schwarz %3, weiß %4</translation>
    </message>
</context>
<context>
    <name>tetra::StatisticsPanel</name>
    <message>
        <source>Mesh sizes</source>
        <translation>Netzgrößen</translation>
    </message>
    <message>
        <source>What the mesh of each error costs: its error in percent of the range of values and in their units, its size, the time to extract it, as measured here, and the memory that it occupies. Choose a line to see that mesh.</source>
        <translation>Was das Netz jedes Fehlers kostet: der Fehler in Prozent des Wertebereichs und in den Einheiten der Werte, die Größe, die Zeit für die Extraktion, wie hier gemessen, und der Speicher, den es belegt. Eine Zeile wählen, um dieses Netz zu sehen.</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>Copy as text, with tabs between the columns</source>
        <translation>Kopiert als Text, mit Tabulatoren zwischen den Spalten</translation>
    </message>
    <message>
        <source>Save the table as CSV or JSON (percent, decimal point)</source>
        <translation>Speichert die Tabelle als CSV oder JSON (Prozent, Dezimalpunkt)</translation>
    </message>
</context>
<context>
    <name>tetra::StatusLine</name>
    <message>
        <source>The picture at the chosen accuracy is being made</source>
        <translation>Das Bild in der gewählten Genauigkeit entsteht gerade</translation>
    </message>
    <message>
        <source>Data points in the mesh that is shown</source>
        <translation>Datenpunkte im gezeigten Netz</translation>
    </message>
    <message>
        <source>Tetrahedra in the mesh that is shown</source>
        <translation>Tetraeder im gezeigten Netz</translation>
    </message>
    <message>
        <source>Triangles of all surfaces that are shown</source>
        <translation>Dreiecke aller gezeigten Flächen</translation>
    </message>
    <message>
        <source>Time for taking the mesh out of the model</source>
        <translation>Zeit, um das Netz aus dem Modell zu holen</translation>
    </message>
    <message>
        <source>Memory that the program occupies, mapped files included</source>
        <translation>Speicher, den das Programm belegt, eingeblendete Dateien eingeschlossen</translation>
    </message>
    <message>
        <source>What draws the picture: OpenGL or the processor</source>
        <translation>Was das Bild zeichnet: OpenGL oder der Prozessor</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Knoten</translation>
    </message>
    <message>
        <source>%1 tetrahedra</source>
        <translation>%1 Tetraeder</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>extracted in %1</source>
        <translation>extrahiert in %1</translation>
    </message>
    <message>
        <source>%1 per frame</source>
        <translation>%1 je Bild</translation>
    </message>
    <message>
        <source>Time for drawing the last picture; while it moves the frames a second, and how much smaller and of how many tetrahedra they are</source>
        <translation>Zeit für das Zeichnen des letzten Bildes; in Bewegung die Bilder in der Sekunde, und wie viel kleiner und aus wie vielen Tetraedern sie sind</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>size 1/%1</source>
        <translation>Größe 1/%1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Value and place that were picked in the picture, in the units of the data. Click elsewhere to pick another one, Esc takes the mark away.</source>
        <translation>Wert und Ort, die im Bild gewählt wurden, in den Einheiten der Daten. Ein Klick anderswo wählt einen anderen, Esc nimmt die Markierung weg.</translation>
    </message>
</context>
<context>
    <name>tetra::TaskLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>tetra::TransferCanvas</name>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>Point %1 of %2: value %3, opacity %4</source>
        <translation>Punkt %1 von %2: Wert %3, Deckkraft %4</translation>
    </message>
    <message>
        <source>Opacity against value. Drag points, click the curve or double click to add one, Delete removes; arrow keys move (finer with Ctrl, farther with Shift), Tab goes to the next. A frame or Ctrl+click selects several. The wheel zooms the values, with Ctrl the opacities; Home shows all. Ctrl+digit makes a group, the digit selects it. Behind: how often the values occur in the mesh.</source>
        <translation>Deckkraft über dem Wert. Punkte ziehen, mit Klick auf die Kurve oder Doppelklick einen hinzufügen, Entf entfernt; Pfeiltasten bewegen (feiner mit Strg, weiter mit Umschalt), Tab geht zum nächsten. Ein Rahmen oder Strg+Klick wählt mehrere aus. Das Rad vergrößert die Werte, mit Strg die Deckkraft; Pos1 zeigt alles. Strg+Ziffer bildet eine Gruppe, die Ziffer wählt sie aus. Dahinter: wie oft die Werte im Netz vorkommen.</translation>
    </message>
    <message>
        <source>%1 points are selected</source>
        <translation>%1 Punkte sind ausgewählt</translation>
    </message>
    <message>
        <source>Value %1, opacity %2</source>
        <translation>Wert %1, Deckkraft %2</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>Isovalue %1 of %2: %3</source>
        <translation>Isowert %1 von %2: %3</translation>
    </message>
    <message>
        <source>Lower end of the mask: %1</source>
        <translation>Unteres Ende der Maske: %1</translation>
    </message>
    <message>
        <source>Upper end of the mask: %1</source>
        <translation>Oberes Ende der Maske: %1</translation>
    </message>
</context>
<context>
    <name>tetra::TransferPanel</name>
    <message>
        <source>S&amp;tep</source>
        <translation>S&amp;tufe</translation>
    </message>
    <message>
        <source>Lo&amp;garithmic</source>
        <translation>Lo&amp;garithmisch</translation>
    </message>
    <message>
        <source>Give the point two sides: what lies below its value ends there, and what lies above begins</source>
        <translation>Dem Punkt zwei Seiten geben: was unter seinem Wert liegt, endet dort, und was darüber liegt, beginnt</translation>
    </message>
    <message>
        <source>Show how often values occur on a logarithmic scale, so that rare ones are seen</source>
        <translation>Die Häufigkeit der Werte logarithmisch zeigen, damit man auch seltene sieht</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Transfer-function presets</source>
        <translation>Vorlagen für Transferfunktionen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden …</translation>
    </message>
    <message>
        <source>Take a transfer function from a file: one of TAn or presets of ParaView (JSON or XML)</source>
        <translation>Eine Transferfunktion aus einer Datei nehmen: eine von TAn oder Vorlagen von ParaView (JSON oder XML)</translation>
    </message>
    <message>
        <source>The file holds several presets:</source>
        <translation>Die Datei enthält mehrere Vorlagen:</translation>
    </message>
    <message>
        <source>Save for &amp;ParaView…</source>
        <translation>Für &amp;ParaView speichern …</translation>
    </message>
    <message>
        <source>Save Transfer Function for ParaView</source>
        <translation>Transferfunktion für ParaView speichern</translation>
    </message>
    <message>
        <source>ParaView presets (*.json)</source>
        <translation>ParaView-Vorlagen (*.json)</translation>
    </message>
    <message>
        <source>Transfer functions (*.json *.xml)</source>
        <translation>Transferfunktionen (*.json *.xml)</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Save the transfer function as a JSON file, which “tan render” takes, too</source>
        <translation>Die Transferfunktion als JSON-Datei speichern, die auch „tan render“ nimmt</translation>
    </message>
    <message>
        <source>Load Transfer Function</source>
        <translation>Transferfunktion laden</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Transferfunktionen (*.json)</translation>
    </message>
    <message>
        <source>Save Transfer Function</source>
        <translation>Transferfunktion speichern</translation>
    </message>
    <message>
        <source>Axis of opacities</source>
        <translation>Achse der Deckkraft</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linear</translation>
    </message>
    <message>
        <source>S&amp;quare root</source>
        <translation>&amp;Quadratwurzel</translation>
    </message>
    <message>
        <source>L&amp;ogarithmic: fine near zero</source>
        <translation>L&amp;ogarithmisch: fein nahe null</translation>
    </message>
    <message>
        <source>Zoom to the &amp;selected points</source>
        <translation>Auf die &amp;ausgewählten Punkte vergrößern</translation>
    </message>
    <message>
        <source>Zoom to the &amp;values of the data</source>
        <translation>Auf die &amp;Werte der Daten vergrößern</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>A&amp;lles zeigen</translation>
    </message>
    <message>
        <source>Value, opacity, colour and how often it occurs, at the pointer</source>
        <translation>Wert, Deckkraft, Farbe und Häufigkeit unter dem Mauszeiger</translation>
    </message>
    <message>
        <source>Add a point after the selected one, or click on the curve, or double click in the plot</source>
        <translation>Einen Punkt nach dem ausgewählten hinzufügen; oder auf die Kurve klicken, oder doppelt in das Diagramm</translation>
    </message>
    <message>
        <source>Remove what is selected (Del)</source>
        <translation>Das Ausgewählte entfernen (Entf)</translation>
    </message>
    <message>
        <source>Change the selected points, or all</source>
        <translation>Die ausgewählten Punkte ändern, oder alle</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>How the plot is shown</source>
        <translation>Wie das Diagramm gezeigt wird</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Show some values only: between two lines that can be dragged</source>
        <translation>Nur einige Werte zeigen: zwischen zwei Linien, die sich ziehen lassen</translation>
    </message>
    <message>
        <source>Show all points in a table to be edited</source>
        <translation>Alle Punkte in einer Tabelle zum Bearbeiten zeigen</translation>
    </message>
    <message>
        <source>Read-out</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Einen Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove what is selected</source>
        <translation>Das Ausgewählte entfernen</translation>
    </message>
    <message>
        <source>Axis of values</source>
        <translation>Achse der Werte</translation>
    </message>
    <message>
        <source>Li&amp;near</source>
        <translation>Li&amp;near</translation>
    </message>
    <message>
        <source>Logarithmic: by &amp;factors</source>
        <translation>Logarithmisch: nach &amp;Faktoren</translation>
    </message>
    <message>
        <source>The axis of values stays linear: a logarithmic one has no place for zero and less, and the data or the points begin at %1. Move the points above zero, or choose data of positive values.</source>
        <translation>Die Achse der Werte bleibt linear: eine logarithmische hat keinen Platz für null und weniger, und die Daten oder die Punkte beginnen bei %1. Die Punkte über null schieben oder Daten mit positiven Werten wählen.</translation>
    </message>
</context>
<context>
    <name>tetra::ValuePick</name>
    <message>
        <source>%1 at (%2, %3, %4)</source>
        <translation>%1 bei (%2, %3, %4)</translation>
    </message>
</context>
<context>
    <name>tetra::ViewPanel</name>
    <message>
        <source>&amp;Load…</source>
        <translation>&amp;Laden …</translation>
    </message>
    <message>
        <source>Sa&amp;ve…</source>
        <translation>Spei&amp;chern …</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>From the camera to the target, in data units</source>
        <translation>Von der Kamera zum Ziel, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>View angle</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>View angle along the shorter side of the picture, in degrees</source>
        <translation>Bildwinkel entlang der kürzeren Bildseite, in Grad</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektivisch</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Whether what is farther away looks smaller (Ctrl+P)</source>
        <translation>Ob kleiner aussieht, was weiter weg ist (Strg+P)</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>The point that is looked at, in the units of the data</source>
        <translation>Der Punkt, auf den geblickt wird, in den Einheiten der Daten</translation>
    </message>
    <message>
        <source>A&amp;zimuth</source>
        <translation>A&amp;zimut</translation>
    </message>
    <message>
        <source>E&amp;levation</source>
        <translation>H&amp;öhe</translation>
    </message>
    <message>
        <source>D&amp;istance</source>
        <translation>Abs&amp;tand</translation>
    </message>
    <message>
        <source>View &amp;angle</source>
        <translation>Bildw&amp;inkel</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>Pro&amp;jektion</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Von dieser Seite blicken</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole domain (Home)</source>
        <translation>Das ganze Gebiet zeigen (Pos1)</translation>
    </message>
    <message>
        <source>Colour behind what is shown, also in saved pictures</source>
        <translation>Farbe hinter dem Gezeigten, auch in gespeicherten Bildern</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Hintergrundfarbe</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>The colour that fits the window, light or dark</source>
        <translation>Die Farbe, die zum Fenster passt, hell oder dunkel</translation>
    </message>
    <message>
        <source>Take the camera from a JSON file</source>
        <translation>Die Kamera aus einer JSON-Datei nehmen</translation>
    </message>
    <message>
        <source>Save the camera as a JSON file, which “tan render --camera” takes, too</source>
        <translation>Die Kamera als JSON-Datei speichern, die auch „tan render --camera“ nimmt</translation>
    </message>
    <message>
        <source>Bac&amp;kground</source>
        <translation>Hinter&amp;grund</translation>
    </message>
    <message>
        <source>Load Camera</source>
        <translation>Kamera laden</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>Kameras (*.json)</translation>
    </message>
    <message>
        <source>Save Camera</source>
        <translation>Kamera speichern</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Direction around the up axis, in degrees</source>
        <translation>Richtung um die senkrechte Achse, in Grad</translation>
    </message>
    <message>
        <source>Height above the plane across the up axis, in degrees</source>
        <translation>Höhe über der Ebene quer zur senkrechten Achse, in Grad</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>By how much the picture is turned clockwise, in degrees</source>
        <translation>Um wie viel das Bild im Uhrzeigersinn gedreht ist, in Grad</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>Which axis of the data points up</source>
        <translation>Welche Achse der Daten nach oben zeigt</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Whether dragging turns the model around the up axis, or freely in any direction (Ctrl+T)</source>
        <translation>Ob Ziehen das Modell um die senkrechte Achse dreht oder frei in jede Richtung (Strg+T)</translation>
    </message>
    <message>
        <source>&amp;Roll</source>
        <translation>&amp;Neigung</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Dra&amp;gging</source>
        <translation>&amp;Ziehen</translation>
    </message>
</context>
<context>
    <name>tetra::Viewport</name>
    <message>
        <source>OpenGL cannot be used, the picture is drawn by the processor instead. %1</source>
        <translation>OpenGL ist nicht benutzbar, stattdessen zeichnet der Prozessor das Bild. %1</translation>
    </message>
</context>
</TS>
