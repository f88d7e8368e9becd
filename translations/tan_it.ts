<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it">
<context>
    <name>Actions</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;File</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Apri…</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Apre un insieme di dati o un modello</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Apri &amp;recente</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>Salva &amp;immagine…</translation>
    </message>
    <message>
        <source>Save the view as a PNG picture</source>
        <translation>Salva la vista come immagine PNG</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>C&amp;hiudi</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Esci</translation>
    </message>
    <message>
        <source>Quit TAn</source>
        <translation>Esce da TAn</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifica</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ripeti</translation>
    </message>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>A&amp;ggiungi isovalore</translation>
    </message>
    <message>
        <source>Add an isosurface at another value</source>
        <translation>Aggiunge un&apos;isosuperficie a un altro valore</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Fronte</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retro</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Sinistra</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Destra</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Alto</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Basso</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>Angol&amp;o</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Guarda da questo lato</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Adatta</translation>
    </message>
    <message>
        <source>Show the whole domain</source>
        <translation>Mostra l&apos;intero dominio</translation>
    </message>
    <message>
        <source>&amp;Look From</source>
        <translation>&amp;Guarda da</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Prospettiva</translation>
    </message>
    <message>
        <source>Perspective, or parallel projection</source>
        <translation>Proiezione prospettica o parallela</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pa&amp;nnelli</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>&amp;Ripristina disposizione</translation>
    </message>
    <message>
        <source>Restore the default layout</source>
        <translation>Ripristina la disposizione predefinita</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>Schermo &amp;intero</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Usa l&apos;intero schermo</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <source>&amp;Plugins…</source>
        <translation>&amp;Plugin…</translation>
    </message>
    <message>
        <source>The plugins that were found</source>
        <translation>I plugin trovati</translation>
    </message>
    <message>
        <source>&amp;About TAn</source>
        <translation>&amp;Informazioni su TAn</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versione e licenza</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Strumenti</translation>
    </message>
    <message>
        <source>Save &amp;Mesh…</source>
        <translation>Salva &amp;mesh…</translation>
    </message>
    <message>
        <source>Save the mesh shown, for VTK, ParaView and others</source>
        <translation>Salva la mesh mostrata, per VTK, ParaView e altri</translation>
    </message>
    <message>
        <source>Save S&amp;urfaces…</source>
        <translation>Salva s&amp;uperfici…</translation>
    </message>
    <message>
        <source>Save the isosurfaces shown, for 3D printers, Blender, ParaView and others</source>
        <translation>Salva le isosuperfici mostrate, per stampanti 3D, Blender, ParaView e altri</translation>
    </message>
    <message>
        <source>Save Stat&amp;istics…</source>
        <translation>Salva s&amp;tatistiche…</translation>
    </message>
    <message>
        <source>Save the mesh size at each accuracy as a table</source>
        <translation>Salva come tabella la dimensione della mesh per ogni accuratezza</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>&amp;Regione</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>&amp;Save Session</source>
        <translation>&amp;Salva sessione</translation>
    </message>
    <message>
        <source>Save what is open and its view, to continue later</source>
        <translation>Salva ciò che è aperto con la sua vista, per continuare più tardi</translation>
    </message>
    <message>
        <source>Save Session &amp;As…</source>
        <translation>Salva sessione &amp;con nome…</translation>
    </message>
    <message>
        <source>Save the session in another file</source>
        <translation>Salva la sessione in un altro file</translation>
    </message>
    <message>
        <source>Import with Op&amp;tions…</source>
        <translation>Importa con &amp;opzioni…</translation>
    </message>
    <message>
        <source>Open a part of a dataset, or choose how its file is read</source>
        <translation>Apre una parte di un insieme di dati, o sceglie come leggere il suo file</translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation>&amp;Trova comando…</translation>
    </message>
    <message>
        <source>Search all commands</source>
        <translation>Cerca fra tutti i comandi</translation>
    </message>
    <message>
        <source>Reduced &amp;Motion</source>
        <translation>Movimento ri&amp;dotto</translation>
    </message>
    <message>
        <source>Disable camera animation</source>
        <translation>Disattiva l&apos;animazione della camera</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Lingua</translation>
    </message>
    <message>
        <source>&amp;Help on This Control</source>
        <translation>&amp;Guida a questo controllo</translation>
    </message>
    <message>
        <source>Explain the focused control</source>
        <translation>Spiega il controllo attivo</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>&amp;Che cos&apos;è?</translation>
    </message>
    <message>
        <source>Click on a control to read what it does</source>
        <translation>Fare clic su un controllo per leggere che cosa fa</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Non c&apos;è nulla da annullare</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Non c&apos;è nulla da ripetere</translation>
    </message>
    <message>
        <source>Save &amp;Film…</source>
        <translation>Salva &amp;filmato…</translation>
    </message>
    <message>
        <source>Save the animation as pictures or a video</source>
        <translation>Salva l&apos;animazione come immagini o come video</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>&amp;Copia immagine</translation>
    </message>
    <message>
        <source>Copy the view to the clipboard</source>
        <translation>Copia la vista negli appunti</translation>
    </message>
    <message>
        <source>&amp;Annotations</source>
        <translation>Annota&amp;zioni</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuale</translation>
    </message>
    <message>
        <source>Open the manual in the browser</source>
        <translation>Apre il manuale nel browser</translation>
    </message>
    <message>
        <source>Picked &amp;Value</source>
        <translation>&amp;Valore scelto</translation>
    </message>
    <message>
        <source>Close the model and its dataset</source>
        <translation>Chiude il modello e il suo insieme di dati</translation>
    </message>
    <message>
        <source>Reset &amp;View</source>
        <translation>Reimposta &amp;vista</translation>
    </message>
    <message>
        <source>Go back to the default accuracy, colours, isovalues and camera</source>
        <translation>Ripristina accuratezza, colori, isovalori e camera iniziali</translation>
    </message>
    <message>
        <source>There is nothing to close</source>
        <translation>Non c’è nulla da chiudere</translation>
    </message>
    <message>
        <source>Open Samp&amp;le</source>
        <translation>Apri esem&amp;pio</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>&amp;Orientamento</translation>
    </message>
</context>
<context>
    <name>Annotations</name>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>%1 units at the target</source>
        <translation>%1 unità alla distanza del punto mirato</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 unità</translation>
    </message>
    <message>
        <source>Colour &amp;bar</source>
        <translation>&amp;Barra dei colori</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;ssi</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>Barra &amp;di scala</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titolo</translation>
    </message>
    <message>
        <source>A&amp;ccuracy</source>
        <translation>A&amp;ccuratezza</translation>
    </message>
    <message>
        <source>Values and their colours, in the units of the data; right their opacity, with marks at the isovalues</source>
        <translation>I valori e i loro colori, nelle unità dei dati; a destra l&apos;opacità, con segni agli isovalori</translation>
    </message>
    <message>
        <source>The directions of x, y and z</source>
        <translation>Le direzioni di x, y e z</translation>
    </message>
    <message>
        <source>A length in the units of the data; in perspective that of things as far away as the target</source>
        <translation>Una lunghezza nelle unità dei dati; in prospettiva quella delle cose distanti quanto il punto mirato</translation>
    </message>
    <message>
        <source>The name of the model</source>
        <translation>Il nome del modello</translation>
    </message>
    <message>
        <source>The error that what is shown keeps, in % of the value range</source>
        <translation>L&apos;errore che ciò che si vede non supera, in % dell&apos;intervallo dei valori</translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>%1 Up</source>
        <translation>%1 in alto</translation>
    </message>
    <message>
        <source>%1 Down</source>
        <translation>%1 in basso</translation>
    </message>
</context>
<context>
    <name>ChangeView</name>
    <message>
        <source>Add Isovalue</source>
        <translation>Aggiungi isovalore</translation>
    </message>
    <message>
        <source>Change Animation</source>
        <translation>Modifica animazione</translation>
    </message>
    <message>
        <source>Change Annotations</source>
        <translation>Modifica annotazioni</translation>
    </message>
    <message>
        <source>Change Isovalue</source>
        <translation>Modifica isovalore</translation>
    </message>
    <message>
        <source>Change Rendering Mode</source>
        <translation>Modifica modalità di resa</translation>
    </message>
    <message>
        <source>Change Transfer Function</source>
        <translation>Modifica funzione di trasferimento</translation>
    </message>
    <message>
        <source>Change Rendering</source>
        <translation>Modifica resa</translation>
    </message>
    <message>
        <source>Change Focus</source>
        <translation>Modifica focus</translation>
    </message>
    <message>
        <source>Change Window</source>
        <translation>Modifica finestra</translation>
    </message>
    <message>
        <source>Change Values</source>
        <translation>Modifica valori</translation>
    </message>
    <message>
        <source>Change Budget</source>
        <translation>Modifica limite</translation>
    </message>
    <message>
        <source>Change Accuracy</source>
        <translation>Modifica accuratezza</translation>
    </message>
    <message>
        <source>Change Background</source>
        <translation>Modifica sfondo</translation>
    </message>
    <message>
        <source>Move Camera</source>
        <translation>Sposta la camera</translation>
    </message>
    <message>
        <source>Remove Isovalue</source>
        <translation>Rimuovi isovalore</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>There is no display for the window: neither DISPLAY nor WAYLAND_DISPLAY is set. “tan render” draws pictures into files instead; “tan --help” says what else works without a window.</source>
        <translation>Non c&apos;è uno schermo per la finestra: né DISPLAY né WAYLAND_DISPLAY è impostata. “tan render” disegna invece le immagini in file; “tan --help” dice che cos&apos;altro funziona senza finestra.</translation>
    </message>
    <message>
        <source>Shows volume data at any accuracy.</source>
        <translation>Mostra dati di volume con qualsiasi accuratezza.</translation>
    </message>
    <message>
        <source>What draws the picture: auto, cpu or gl.</source>
        <translation>Che cosa disegna l&apos;immagine: auto, cpu o gl.</translation>
    </message>
    <message>
        <source>A dataset, a .tan model or a session to open.</source>
        <translation>Un insieme di dati, un modello .tan o una sessione da aprire.</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Build</source>
        <translation>Costruzione</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Accuratezza</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendering</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isovalori</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Trasferimento</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Focus</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Regione</translation>
    </message>
    <message>
        <source>A dataset is turned into a model once: a mesh of tetrahedra that can be had at any accuracy from then on. Choose a method and a file, and start.</source>
        <translation>Un insieme di dati diventa una volta sola un modello: una mesh di tetraedri disponibile da allora con qualsiasi accuratezza. Scegliere un metodo e un file, e cominciare.</translation>
    </message>
    <message>
        <source>How far the mesh may deviate from the data, in percent of the range of values; or how many tetrahedra it may have. The curve shows what each error costs.</source>
        <translation>Di quanto la mesh può scostarsi dai dati, in percento dell&apos;intervallo dei valori, oppure quanti tetraedri può avere. La curva mostra quanto costa ogni errore.</translation>
    </message>
    <message>
        <source>Rendering mode and its settings: surfaces, volume or both.</source>
        <translation>Modo di rendering e impostazioni: superfici, volume o entrambi.</translation>
    </message>
    <message>
        <source>From where the model is seen, in numbers. In the picture: drag to turn, Shift and drag to move, the wheel zooms.</source>
        <translation>Da dove si vede il modello, in numeri. Nell&apos;immagine: trascinare per ruotare, Maiusc e trascinare per spostare, la rotella ingrandisce.</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistiche</translation>
    </message>
    <message>
        <source>What each accuracy costs in vertices, tetrahedra, time and memory, and the mesh shown now in numbers.</source>
        <translation>Quanto costa ogni accuratezza in vertici, tetraedri, tempo e memoria, e la mesh mostrata in numeri.</translation>
    </message>
    <message>
        <source>Surfaces on which the field has one value each, in the units of the data.</source>
        <translation>Superfici su ciascuna delle quali il campo ha un solo valore, nelle unità dei dati.</translation>
    </message>
    <message>
        <source>The transfer function gives each value a colour and an opacity for the volume.</source>
        <translation>La funzione di trasferimento dà a ogni valore un colore e un&apos;opacità per il volume.</translation>
    </message>
    <message>
        <source>A sphere or a box in which the mesh is more accurate than outside.</source>
        <translation>Una sfera o un parallelepipedo in cui la mesh è più accurata che all&apos;esterno.</translation>
    </message>
    <message>
        <source>Which part of the domain is shown at all: a box, and a range of values.</source>
        <translation>Quale parte del dominio si mostra: un parallelepipedo e un intervallo di valori.</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animazione</translation>
    </message>
    <message>
        <source>Films of the model: a turntable, or a path through key frames that you choose.</source>
        <translation>Filmati del modello: un giro completo, o un percorso tra fotogrammi chiave scelti da voi.</translation>
    </message>
</context>
<context>
    <name>EditorPage</name>
    <message>
        <source>The editor cannot be used. %1</source>
        <translation>L&apos;editor non si può usare. %1</translation>
    </message>
    <message>
        <source>Help › Plugins lists all plugins and where they are looked for.</source>
        <translation>Aiuto › Plugin elenca tutti i plugin e dove vengono cercati.</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open a Dataset or a Model</source>
        <translation>Apri un insieme di dati o un modello</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Salva immagine</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Immagini PNG (*.png)</translation>
    </message>
    <message>
        <source>Save Mesh</source>
        <translation>Salva mesh</translation>
    </message>
    <message>
        <source>VTK XML unstructured grids (*.vtu)</source>
        <translation>Griglie non strutturate VTK XML (*.vtu)</translation>
    </message>
    <message>
        <source>Boundary as VTK XML polydata (*.vtp)</source>
        <translation>Contorno come VTK XML polydata (*.vtp)</translation>
    </message>
    <message>
        <source>Boundary as STL (*.stl)</source>
        <translation>Contorno come STL (*.stl)</translation>
    </message>
    <message>
        <source>Boundary as Wavefront OBJ (*.obj)</source>
        <translation>Contorno come Wavefront OBJ (*.obj)</translation>
    </message>
    <message>
        <source>Boundary as binary glTF (*.glb)</source>
        <translation>Contorno come glTF binario (*.glb)</translation>
    </message>
    <message>
        <source>Save Surfaces</source>
        <translation>Salva superfici</translation>
    </message>
    <message>
        <source>STL files (*.stl)</source>
        <translation>File STL (*.stl)</translation>
    </message>
    <message>
        <source>Wavefront OBJ files (*.obj)</source>
        <translation>File Wavefront OBJ (*.obj)</translation>
    </message>
    <message>
        <source>Binary glTF files (*.glb)</source>
        <translation>File glTF binari (*.glb)</translation>
    </message>
    <message>
        <source>VTK XML polydata (*.vtp)</source>
        <translation>VTK XML polydata (*.vtp)</translation>
    </message>
    <message>
        <source>Save Statistics</source>
        <translation>Salva statistiche</translation>
    </message>
    <message>
        <source>Tables of comma-separated values (*.csv)</source>
        <translation>Tabelle di valori separati da virgole (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>VTK legacy files (*.vtk)</source>
        <translation>File VTK legacy (*.vtk)</translation>
    </message>
    <message>
        <source>PLY files (*.ply)</source>
        <translation>File PLY (*.ply)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
</context>
<context>
    <name>HelpActions</name>
    <message>
        <source>Restart TAn to change the language.</source>
        <translation>Riavviare TAn per cambiare lingua.</translation>
    </message>
    <message>
        <source>&amp;As the System</source>
        <translation>&amp;Come il sistema</translation>
    </message>
</context>
<context>
    <name>ImportForm</name>
    <message>
        <source>%1 (of the cells)</source>
        <translation>%1 (delle celle)</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Modulo</translation>
    </message>
    <message>
        <source>%1: t = %2</source>
        <translation>%1: t = %2</translation>
    </message>
    <message>
        <source>All that fit together</source>
        <translation>Tutti quelli compatibili fra loro</translation>
    </message>
    <message>
        <source>%1, %2 components</source>
        <translation>%1, %2 componenti</translation>
    </message>
</context>
<context>
    <name>ImportTexts</name>
    <message>
        <source>%1 = %2 bytes: the file has exactly that.</source>
        <translation>%1 = %2 byte: il file ne ha esattamente tanti.</translation>
    </message>
    <message>
        <source>All %1 = %2 points.</source>
        <translation>Tutti i %1 = %2 punti.</translation>
    </message>
    <message>
        <source>%1 = %2 of %3 points.</source>
        <translation>%1 = %2 di %3 punti.</translation>
    </message>
    <message>
        <source>The build takes about %1 of memory, %2 of disk and %3.</source>
        <translation>La costruzione richiede circa %1 di memoria, %2 di disco e %3.</translation>
    </message>
    <message>
        <source>The build takes up to %1 of memory, %2 of disk and %3.</source>
        <translation>La costruzione richiede fino a %1 di memoria, %2 di disco e %3.</translation>
    </message>
    <message>
        <source>This machine has %1 of memory.</source>
        <translation>Questo computer ha %1 di memoria.</translation>
    </message>
    <message>
        <source>A volume needs at least two points along each axis. Take a larger region or a smaller stride.</source>
        <translation>Un volume richiede almeno due punti lungo ogni asse. Prendere una regione più grande o un passo più piccolo.</translation>
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
        <translation>%1 = %2 byte; il file ne ha %3 (%4 mancanti).</translation>
    </message>
    <message>
        <source>%1 = %2 bytes; the file has %3 (%4 too many).</source>
        <translation>%1 = %2 byte; il file ne ha %3 (%4 in più).</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>The manual is not installed. Install the package tan again with its documentation, or build TAn with the package python3-markdown; the same texts are in the folder docs of its sources.</source>
        <translation>Il manuale non è installato. Installare di nuovo il pacchetto tan con la sua documentazione, oppure compilare TAn con il pacchetto python3-markdown; gli stessi testi sono nella cartella docs dei sorgenti.</translation>
    </message>
    <message>
        <source>No program opens web pages here. Install a web browser, or read %1.</source>
        <translation>Qui nessun programma apre pagine web. Installare un browser, oppure leggere %1.</translation>
    </message>
</context>
<context>
    <name>MeshText</name>
    <message>
        <source>Limited by the budget of %1 tetrahedra.</source>
        <translation>Limitato dal budget di %1 tetraedri.</translation>
    </message>
    <message>
        <source>Full resolution of the model.</source>
        <translation>Risoluzione piena del modello.</translation>
    </message>
    <message>
        <source>The model contains no finer level.</source>
        <translation>Il modello non contiene livelli più fini.</translation>
    </message>
    <message>
        <source>%1 of its %2 tetrahedra are shown.</source>
        <translation>Si mostrano %1 dei suoi %2 tetraedri.</translation>
    </message>
    <message>
        <source>error %1 in the focus, %2 outside</source>
        <translation>errore %1 nel focus, %2 all&apos;esterno</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>errore %1</translation>
    </message>
    <message>
        <source>Shown: %1, and the same warping.</source>
        <translation>Mostrato: %1, deformazione uguale.</translation>
    </message>
    <message>
        <source>Shown: %1.</source>
        <translation>Mostrato: %1.</translation>
    </message>
    <message>
        <source>%1 tetrahedra in %2 pieces, as the window cuts them</source>
        <translation>%1 tetraedri in %2 pezzi, tagliati dalla finestra</translation>
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
        <translation>Arancione</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Celeste</translation>
    </message>
    <message>
        <source>Bluish green</source>
        <translation>Verde bluastro</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Vermiglio</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blu</translation>
    </message>
    <message>
        <source>Reddish purple</source>
        <translation>Porpora rossastro</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Giallo</translation>
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
        <translation>Ora non è possibile</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Pannello</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Accuratezza</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
</context>
<context>
    <name>Plugin</name>
    <message>
        <source>Delaunay refinement</source>
        <translation>Raffinamento di Delaunay</translation>
    </message>
    <message>
        <source>Starts from the corners and inserts the point of the largest error until the error is small enough.</source>
        <translation>Parte dai vertici del dominio e inserisce il punto di massimo errore finché l&apos;errore è abbastanza piccolo.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>The error at which to stop; 0 keeps everything, so that any accuracy can be shown later.</source>
        <translation>L&apos;errore a cui fermarsi; 0 conserva tutto, così poi si può mostrare qualsiasi accuratezza.</translation>
    </message>
    <message>
        <source>% of the value range</source>
        <translation>% dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Tables of points</source>
        <translation>Tabelle di punti</translation>
    </message>
    <message>
        <source>Reads scattered points with a value each from CSV, TSV and blank-separated text.</source>
        <translation>Legge punti sparsi con un valore ciascuno da CSV, TSV e testo separato da spazi.</translation>
    </message>
    <message>
        <source>CSV writer</source>
        <translation>Scrittura CSV</translation>
    </message>
    <message>
        <source>Writes the points of any dataset as a table: x, y, z and value.</source>
        <translation>Scrive i punti di qualsiasi insieme di dati come tabella: x, y, z e valore.</translation>
    </message>
    <message>
        <source>Table of points (*.csv *.tsv *.xyz *.pts *.txt *.asc)</source>
        <translation>Tabella di punti (*.csv *.tsv *.xyz *.pts *.txt *.asc)</translation>
    </message>
    <message>
        <source>Table of points (*.csv)</source>
        <translation>Tabella di punti (*.csv)</translation>
    </message>
    <message>
        <source>Meshes of cells</source>
        <translation>Mesh di celle</translation>
    </message>
    <message>
        <source>Reads meshes of tetrahedra, hexahedra, prisms and pyramids from VTK XML (.vtu) and AVS UCD (.inp).</source>
        <translation>Legge mesh di tetraedri, esaedri, prismi e piramidi da VTK XML (.vtu) e AVS UCD (.inp).</translation>
    </message>
    <message>
        <source>VTU writer</source>
        <translation>Scrittura VTU</translation>
    </message>
    <message>
        <source>Writes meshes of tetrahedra as VTK XML unstructured grids.</source>
        <translation>Scrive mesh di tetraedri come griglie non strutturate VTK XML.</translation>
    </message>
    <message>
        <source>VTK unstructured grid (*.vtu)</source>
        <translation>Griglia non strutturata VTK (*.vtu)</translation>
    </message>
    <message>
        <source>AVS UCD mesh (*.inp)</source>
        <translation>Mesh AVS UCD (*.inp)</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Vettore</translation>
    </message>
    <message>
        <source>The array whose values to take, of points or of cells; nothing takes the one the file calls active, else the first.</source>
        <translation>Il vettore di cui prendere i valori, di punti o di celle; se vuoto quello che il file dice attivo, altrimenti il primo.</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Componente</translation>
    </message>
    <message>
        <source>Of arrays with several components: magnitude, or a number from 0.</source>
        <translation>Di vettori con più componenti: il modulo, o un numero da 0.</translation>
    </message>
    <message>
        <source>Cutting the cells</source>
        <translation>Suddivisione delle celle</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>Controllo della mesh</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posizioni</translation>
    </message>
    <message>
        <source>Tables of points: the columns of x, y and z, by name or number, as in lon,lat,depth or 1,2,3; &apos;automatic&apos; takes those called x, y and z, else the first three.</source>
        <translation>Tabelle di punti: le colonne di x, y e z, per nome o numero, come in lon,lat,depth o 1,2,3; &apos;automatic&apos; prende quelle chiamate x, y e z, altrimenti le prime tre.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valori</translation>
    </message>
    <message>
        <source>The values to take, by name or number; &apos;automatic&apos; takes the first there are.</source>
        <translation>I valori da prendere, per nome o numero; &apos;automatic&apos; prende i primi che ci sono.</translation>
    </message>
    <message>
        <source>Skip incomplete rows</source>
        <translation>Salta le righe incomplete</translation>
    </message>
    <message>
        <source>Tables of points: leave out rows that lack a number, instead of refusing the file.</source>
        <translation>Tabelle di punti: tralascia le righe a cui manca un numero, invece di rifiutare il file.</translation>
    </message>
    <message>
        <source>Scattered points: refinement fills their convex hull.</source>
        <translation>Punti sparsi: il raffinamento riempie il loro inviluppo convesso.</translation>
    </message>
    <message>
        <source>Finding the convex hull</source>
        <translation>Ricerca dell&apos;inviluppo convesso</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesi</translation>
    </message>
    <message>
        <source>Where accuracy matters: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach or value:q,reach, several separated by &apos;;&apos;. Errors there count in full, falling linearly to a tenth (or to &apos;,floor&apos; at the end) at the distance &apos;reach&apos;; the largest weight holds. Examples: &apos;point:16,16,8,10&apos;, &apos;value:120,15,0.05&apos;.</source>
        <translation>Dove conta l&apos;accuratezza: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach o value:q,reach, più di uno separati da &apos;;&apos;. Lì gli errori contano per intero e calano linearmente a un decimo (o a &apos;,floor&apos; alla fine) alla distanza &apos;reach&apos;; vale il peso maggiore. Esempi: &apos;point:16,16,8,10&apos;, &apos;value:120,15,0.05&apos;.</translation>
    </message>
    <message>
        <source>An irregular mesh: decimation keeps its shape and its cavities.</source>
        <translation>Una mesh irregolare: la decimazione ne conserva la forma e le cavità.</translation>
    </message>
    <message>
        <source>A curvilinear grid: decimation takes fewer points for the same accuracy, but more time and memory.</source>
        <translation>Una griglia curvilinea: la decimazione richiede meno punti a pari accuratezza, ma più tempo e memoria.</translation>
    </message>
    <message>
        <source>A regular lattice: decimation takes fewer points for the same accuracy, but more time and memory.</source>
        <translation>Un reticolo regolare: la decimazione richiede meno punti a pari accuratezza, ma più tempo e memoria.</translation>
    </message>
    <message>
        <source>A regular lattice: refinement keeps the exact domain and needs the least time.</source>
        <translation>Un reticolo regolare: il raffinamento conserva esattamente il dominio e richiede il tempo minore.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Blocco</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>celle</translation>
    </message>
    <message>
        <source>Warping</source>
        <translation>Deformazione</translation>
    </message>
    <message>
        <source>% of the diagonal</source>
        <translation>% della diagonale</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Scelta</translation>
    </message>
    <message>
        <source>For curvilinear data: &apos;normalised&apos; takes the point that is farthest off in error or warping; &apos;paper&apos; compares the two in the units of the data, as the paper did, to compare with it. Both keep cells from turning over.</source>
        <translation>Per dati curvilinei: &apos;normalised&apos; prende il punto più lontano per errore o deformazione; &apos;paper&apos; confronta i due nelle unità dei dati, come faceva l&apos;articolo, per confrontarsi con esso. Entrambe evitano che le celle si rovescino.</translation>
    </message>
    <message>
        <source>normalised</source>
        <translation>normalizzata</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>articolo</translation>
    </message>
    <message>
        <source>A curvilinear grid: refinement in computational space bounds both error and warping.</source>
        <translation>Una griglia curvilinea: il raffinamento nello spazio computazionale limita sia l&apos;errore sia la deformazione.</translation>
    </message>
    <message>
        <source>Distributing the points</source>
        <translation>Distribuzione dei punti</translation>
    </message>
    <message>
        <source>Refining</source>
        <translation>Raffinamento</translation>
    </message>
    <message>
        <source>Isosurfaces</source>
        <translation>Isosuperfici</translation>
    </message>
    <message>
        <source>Shows the surfaces on which the field has the chosen values, each with a colour and an opacity.</source>
        <translation>Mostra le superfici su cui il campo ha i valori scelti, ciascuna con un colore e un&apos;opacità.</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isovalori</translation>
    </message>
    <message>
        <source>The values whose surfaces are shown, each with its colour and opacity.</source>
        <translation>I valori di cui si mostrano le superfici, ciascuno con colore e opacità.</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Parallelepipedo limite</translation>
    </message>
    <message>
        <source>Shows the edges of the box that the data fill.</source>
        <translation>Mostra gli spigoli del parallelepipedo che i dati riempiono.</translation>
    </message>
    <message>
        <source>Volumes on regular lattices</source>
        <translation>Volumi su reticoli regolari</translation>
    </message>
    <message>
        <source>Reads NRRD files with attached or detached data, raw, gzip or text, and raw files that are described.</source>
        <translation>Legge file NRRD con dati interni o esterni, raw, gzip o testo, e file raw di cui si dà la descrizione.</translation>
    </message>
    <message>
        <source>NRRD writer</source>
        <translation>Scrittura NRRD</translation>
    </message>
    <message>
        <source>Writes volumes on regular lattices as NRRD files, raw or gzip.</source>
        <translation>Scrive volumi su reticoli regolari come file NRRD, raw o gzip.</translation>
    </message>
    <message>
        <source>NRRD volume (*.nrrd *.nhdr)</source>
        <translation>Volume NRRD (*.nrrd *.nhdr)</translation>
    </message>
    <message>
        <source>Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)</source>
        <translation>Volume raw (*.raw *.bin *.binary *.dat *.img *.vol)</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensione</translation>
    </message>
    <message>
        <source>Raw files: the number of points along x (which runs fastest), y and z, as in 256x256x128.</source>
        <translation>File raw: il numero di punti lungo x (che varia più in fretta), y e z, come in 256x256x128.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punti</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Raw files: the type of a sample.</source>
        <translation>File raw: il tipo di un campione.</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Ordine dei byte</translation>
    </message>
    <message>
        <source>Raw files: little (PC) or big endian, for types of more than one byte.</source>
        <translation>File raw: little (PC) o big endian, per tipi di più di un byte.</translation>
    </message>
    <message>
        <source>little</source>
        <translation>little-endian (PC)</translation>
    </message>
    <message>
        <source>big</source>
        <translation>big-endian</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Salta</translation>
    </message>
    <message>
        <source>Raw files: the length of a header before the samples.</source>
        <translation>File raw: la lunghezza di un&apos;intestazione prima dei campioni.</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>byte</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Spaziatura</translation>
    </message>
    <message>
        <source>Raw files: the distance of neighbouring points along x, y and z, as in 1x1x2.5.</source>
        <translation>File raw: la distanza fra punti vicini lungo x, y e z, come in 1x1x2.5.</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Raw files: the position of the first point, as in 0,0,0.</source>
        <translation>File raw: la posizione del primo punto, come in 0,0,0.</translation>
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
        <translation>costruzione</translation>
    </message>
    <message>
        <source>renderer</source>
        <translation>resa</translation>
    </message>
    <message>
        <source>reader</source>
        <translation>lettura</translation>
    </message>
    <message>
        <source>writer</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>editor</source>
        <translation>editor</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trovato</translation>
    </message>
    <message>
        <source>loaded</source>
        <translation>caricato</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>disattivato</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rifiutato</translation>
    </message>
    <message>
        <source>PLOT3D grids</source>
        <translation>Griglie PLOT3D</translation>
    </message>
    <message>
        <source>Reads curvilinear grids with a scalar of their solution from binary PLOT3D files of any byte order and precision.</source>
        <translation>Legge griglie curvilinee con uno scalare della soluzione da file PLOT3D binari di qualsiasi ordine dei byte e precisione.</translation>
    </message>
    <message>
        <source>PLOT3D writer</source>
        <translation>Scrittura PLOT3D</translation>
    </message>
    <message>
        <source>Writes datasets on grids as a PLOT3D grid file and a solution file beside it.</source>
        <translation>Scrive insiemi di dati su griglie come file di griglia PLOT3D con accanto un file di soluzione.</translation>
    </message>
    <message>
        <source>PLOT3D grid and solution (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</source>
        <translation>Griglia e soluzione PLOT3D (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</translation>
    </message>
    <message>
        <source>Which scalar of the solution: automatic takes the density, or if that is the same everywhere the first that varies.</source>
        <translation>Quale scalare della soluzione: automatico prende la densità o, se questa è ovunque uguale, il primo che varia.</translation>
    </message>
    <message>
        <source>Solution file</source>
        <translation>File di soluzione</translation>
    </message>
    <message>
        <source>The PLOT3D solution of the grid; without it the one beside it with a fitting name.</source>
        <translation>La soluzione PLOT3D della griglia; se vuoto quella accanto con un nome adatto.</translation>
    </message>
    <message>
        <source>VTK readers</source>
        <translation>Letture VTK</translation>
    </message>
    <message>
        <source>Reads VTK, Exodus, EnSight, NetCDF, CGNS, MetaImage, NIfTI, TIFF, DICOM and more, by means of VTK.</source>
        <translation>Legge VTK, Exodus, EnSight, NetCDF, CGNS, MetaImage, NIfTI, TIFF, DICOM e altri, per mezzo di VTK.</translation>
    </message>
    <message>
        <source>Of arrays with several components: the number of one, from 0, or &apos;magnitude&apos;.</source>
        <translation>Di vettori con più componenti: il numero di una, da 0, o &apos;magnitude&apos;.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Passo temporale</translation>
    </message>
    <message>
        <source>Of files with several time steps: which one, from 1.</source>
        <translation>Di file con più passi temporali: quale, da 1.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Of files with several blocks or parts: one, by name or number from 1; without it all irregular meshes that have the values, or the first grid.</source>
        <translation>Di file con più blocchi o parti: una, per nome o numero da 1; se vuoto tutte le mesh irregolari che hanno i valori, o la prima griglia.</translation>
    </message>
    <message>
        <source>VTK XML (*.vti *.vtr *.vts *.vtu *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</source>
        <translation>VTK XML (*.vti *.vtr *.vts *.vtu *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</translation>
    </message>
    <message>
        <source>VTK legacy (*.vtk)</source>
        <translation>VTK legacy (*.vtk)</translation>
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
        <translation>NetCDF, convenzioni CF (*.nc *.cdf)</translation>
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
        <translation>Microscopia elettronica MRC (*.mrc *.ccp4 *.map)</translation>
    </message>
    <message>
        <source>TIFF stack (*.tif *.tiff)</source>
        <translation>Serie TIFF (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>DICOM series (*.dcm *.dicom)</source>
        <translation>Serie DICOM (*.dcm *.dicom)</translation>
    </message>
    <message>
        <source>PLOT3D, also text (*.xyz *.x *.g *.p3d *.q)</source>
        <translation>PLOT3D, anche testo (*.xyz *.x *.g *.p3d *.q)</translation>
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
        <translation>Testo Tecplot (*.tec *.tp)</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Griglia</translation>
    </message>
    <message>
        <source>Which grid of a PLOT3D file that holds several, from 1; 0 takes the only one.</source>
        <translation>Quale griglia di un file PLOT3D che ne contiene più d&apos;una, da 1; 0 prende l&apos;unica.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densità</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>pressione</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energia</translation>
    </message>
    <message>
        <source>velocity_magnitude</source>
        <translation>modulo della velocità</translation>
    </message>
    <message>
        <source>momentum_magnitude</source>
        <translation>modulo della quantità di moto</translation>
    </message>
    <message>
        <source>momentum_x</source>
        <translation>quantità di moto x</translation>
    </message>
    <message>
        <source>momentum_y</source>
        <translation>quantità di moto y</translation>
    </message>
    <message>
        <source>momentum_z</source>
        <translation>quantità di moto z</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>temperatura</translation>
    </message>
    <message>
        <source>mach</source>
        <translation>Mach</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Shows the field as a translucent cloud: a transfer function gives each value its colour and opacity.</source>
        <translation>Mostra il campo come una nube traslucida: una funzione di trasferimento dà a ogni valore colore e opacità.</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Focus</translation>
    </message>
    <message>
        <source>Shows the field as a volume that is finer inside the focus than outside, blended at its border.</source>
        <translation>Mostra il campo come un volume più fine dentro il focus che fuori, sfumato al bordo.</translation>
    </message>
    <message>
        <source>Volume with isosurfaces</source>
        <translation>Volume con isosuperfici</translation>
    </message>
    <message>
        <source>Shows the field as a translucent cloud with surfaces of chosen values in it.</source>
        <translation>Mostra il campo come una nube traslucida con dentro superfici di valori scelti.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Funzione di trasferimento</translation>
    </message>
    <message>
        <source>The colour and the opacity of each value.</source>
        <translation>Il colore e l&apos;opacità di ogni valore.</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Ombreggiato</translation>
    </message>
    <message>
        <source>Lights the volume, as if a surface lay across the direction in which its values change most.</source>
        <translation>Illumina il volume, come se una superficie stesse di traverso alla direzione in cui i valori cambiano di più.</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Piani di taglio</translation>
    </message>
    <message>
        <source>Cuts away what lies before a plane: nx,ny,nz,offset shows the points with nx x + ny y + nz z &gt;= offset.</source>
        <translation>Taglia via ciò che sta davanti a un piano: nx,ny,nz,offset mostra i punti con nx x + ny y + nz z &gt;= offset.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordine</translation>
    </message>
    <message>
        <source>How surfaces and volume are put in order: &apos;exact&apos;, or as the paper did &apos;with-cell&apos;, where the part of a surface in a cell is drawn before the cell.</source>
        <translation>Come si ordinano superfici e volume: &apos;exact&apos;, oppure come faceva l&apos;articolo &apos;with-cell&apos;, dove la parte di superficie in una cella si disegna prima della cella.</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>esatto</translation>
    </message>
    <message>
        <source>with-cell</source>
        <translation>con la cella</translation>
    </message>
    <message>
        <source>Decimation by edge collapse</source>
        <translation>Decimazione per contrazione di spigoli</translation>
    </message>
    <message>
        <source>Starts from the whole mesh and takes away the points that matter least; takes meshes of any shape and keeps their cavities.</source>
        <translation>Parte dall&apos;intera mesh e toglie i punti che contano meno; accetta mesh di qualsiasi forma e ne conserva le cavità.</translation>
    </message>
    <message>
        <source>The error at which to stop; 0 goes on to the coarsest mesh.</source>
        <translation>L&apos;errore a cui fermarsi; 0 prosegue fino alla mesh più grossolana.</translation>
    </message>
    <message>
        <source>Which point goes next: &apos;exact&apos; takes the one whose loss does the least harm, for the fewest points; &apos;paper&apos; estimates that by gradients and planes, as the paper did; &apos;rounds&apos; takes many points at a time that do not touch, so that a focus region needs the least besides.</source>
        <translation>Quale punto togliere per primo: &apos;exact&apos; quello la cui perdita fa meno danno, per il minor numero di punti; &apos;paper&apos; lo stima con gradienti e piani, come faceva l&apos;articolo; &apos;rounds&apos; toglie molti punti per volta che non si toccano, così che una regione di focus richieda meno all&apos;intorno.</translation>
    </message>
    <message>
        <source>rounds</source>
        <translation>a turni</translation>
    </message>
    <message>
        <source>Evaluating vertices</source>
        <translation>Valutazione dei vertici</translation>
    </message>
    <message>
        <source>Collapsing</source>
        <translation>Contrazione</translation>
    </message>
    <message>
        <source>Scattered points have no tetrahedra that decimation could begin with. Refine them instead.</source>
        <translation>I punti sparsi non hanno tetraedri da cui la decimazione possa partire. Usare il raffinamento.</translation>
    </message>
    <message>
        <source>A tetrahedral mesh needs a cell: two points or more along each axis.</source>
        <translation>Una mesh di tetraedri richiede una cella: due o più punti lungo ogni asse.</translation>
    </message>
    <message>
        <source>electron density of the C60 molecule, a hollow ball of smooth bumps</source>
        <translation>densità elettronica della molecola C60, una sfera cava di gobbe lisce</translation>
    </message>
    <message>
        <source>probability density of the hydrogen atom&apos;s 3d electron: two lobes and a ring</source>
        <translation>densità di probabilità dell&apos;elettrone 3d dell&apos;atomo di idrogeno: due lobi e un anello</translation>
    </message>
    <message>
        <source>the test signal of Marschner and Lobb: ripples that are hard to reproduce</source>
        <translation>il segnale di prova di Marschner e Lobb: increspature difficili da riprodurre</translation>
    </message>
    <message>
        <source>white noise, the worst case: no sample tells of its neighbour</source>
        <translation>rumore bianco, il caso peggiore: nessun campione dice nulla del vicino</translation>
    </message>
    <message>
        <source>flow in front of a hemisphere: a curvilinear grid whose axis is collapsed</source>
        <translation>flusso davanti a una semisfera: una griglia curvilinea con l&apos;asse collassato</translation>
    </message>
    <message>
        <source>flow around a cylinder: a curvilinear grid that closes on itself</source>
        <translation>flusso attorno a un cilindro: una griglia curvilinea che si chiude su sé stessa</translation>
    </message>
    <message>
        <source>flow through a bent duct: a curvilinear grid</source>
        <translation>flusso in un condotto curvo: una griglia curvilinea</translation>
    </message>
    <message>
        <source>a layer at a wall: a rectilinear grid with spacings that grow</source>
        <translation>uno strato presso una parete: una griglia rettilinea con spaziature crescenti</translation>
    </message>
    <message>
        <source>random points in a ball, with waves that grow finer outwards</source>
        <translation>punti casuali in una sfera, con onde più fini verso l&apos;esterno</translation>
    </message>
    <message>
        <source>stress in a plate with five holes and a closed cavity: an irregular mesh</source>
        <translation>tensione in una piastra con cinque fori e una cavità chiusa: una mesh irregolare</translation>
    </message>
    <message>
        <source>Transfer function editor</source>
        <translation>Editor della funzione di trasferimento</translation>
    </message>
    <message>
        <source>Edits the colour and the opacity of each value, over how often the values occur.</source>
        <translation>Modifica il colore e l&apos;opacità di ogni valore, sopra la frequenza dei valori.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Shows where the mesh ends, holes and cavities included: &apos;translucent&apos; in one light colour, so that one sees what is inside within its walls, or in the colours that the transfer function gives the &apos;values&apos; there.</source>
        <translation>Mostra dove finisce la mesh, con fori e cavità: «traslucido» in un solo colore chiaro, così che si veda che cosa c&apos;è dentro le sue pareti, oppure con i colori che la funzione di trasferimento dà ai «valori» in quei punti.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>spento</translation>
    </message>
    <message>
        <source>translucent</source>
        <translation>traslucido</translation>
    </message>
    <message>
        <source>values</source>
        <translation>valori</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacità</translation>
    </message>
    <message>
        <source>The opacity of a translucent boundary; 1 hides what lies behind.</source>
        <translation>L&apos;opacità di un contorno traslucido; 1 nasconde ciò che sta dietro.</translation>
    </message>
    <message>
        <source>Back faces only</source>
        <translation>Solo facce posteriori</translation>
    </message>
    <message>
        <source>Shows only the far walls of the boundary, seen from within, and leaves out those that face the camera.</source>
        <translation>Mostra solo le pareti lontane del bordo, dall&apos;interno, e tralascia quelle rivolte verso la camera.</translation>
    </message>
    <message>
        <source>Finest error</source>
        <translation>Errore più fine</translation>
    </message>
    <message>
        <source>Leaves meshes of smaller errors out of the model, so that it is smaller; 0 keeps everything.</source>
        <translation>Tralascia dal modello le mesh con errori minori, così che sia più piccolo; 0 conserva tutto.</translation>
    </message>
    <message>
        <source>The cells along an edge of the blocks that are refined independently, in memory for a few of them; &apos;none&apos; refines the dataset as a whole; &apos;automatic&apos; takes blocks where a lattice is large. The blocks of a curvilinear grid are refined together, all in memory.</source>
        <translation>Le celle lungo uno spigolo dei blocchi raffinati indipendentemente, con memoria per pochi di essi; «nessuno» raffina l&apos;insieme di dati come un tutto; «automatico» usa blocchi dove un reticolo è grande. I blocchi delle griglie curvilinee sono raffinati insieme, tutti in memoria.</translation>
    </message>
    <message>
        <source>For curvilinear and irregular data: the warping at which to stop. Its ratio to the error says how much the shape counts against the values. If one of the two is 0, it is the same number as the other.</source>
        <translation>Per dati curvilinei e irregolari: la deformazione a cui fermarsi. Il suo rapporto con l&apos;errore dice quanto conta la forma rispetto ai valori. Se uno dei due è 0, vale per esso il numero dell&apos;altro.</translation>
    </message>
</context>
<context>
    <name>PointClipboard</name>
    <message>
        <source>The clipboard holds no points of a transfer function. Copy some here or in another window. %1</source>
        <translation>Gli appunti non contengono punti di una funzione di trasferimento. Copiarne alcuni qui o in un&apos;altra finestra. %1</translation>
    </message>
</context>
<context>
    <name>PresetNames</name>
    <message>
        <source>Cool to warm</source>
        <translation>Da freddo a caldo</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grigi</translation>
    </message>
    <message>
        <source>Sequential: opaque where values are large</source>
        <translation>Crescente: opaca dove i valori sono grandi</translation>
    </message>
    <message>
        <source>Diverging: opaque at both ends</source>
        <translation>Divergente: opaca ai due estremi</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>%1 points</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>%1 × %1 × %1 points</source>
        <translation>%1 × %1 × %1 punti</translation>
    </message>
    <message>
        <source>Buckyball</source>
        <translation>Fullerene</translation>
    </message>
    <message>
        <source>Electron density of a C60 molecule; regular grid, %1, computed by TAn. Look at the cage of atoms as an isosurface, and at how few tetrahedra are enough for an error of 1 %.</source>
        <translation>Densità elettronica di una molecola C60; griglia regolare, %1, calcolata da TAn. Da guardare: la gabbia di atomi come isosuperficie, e quanti pochi tetraedri bastano per un errore dell&apos;1 %.</translation>
    </message>
    <message>
        <source>Hydrogen atom</source>
        <translation>Atomo di idrogeno</translation>
    </message>
    <message>
        <source>Probability density of the 3d electron; regular grid, %1, computed by TAn. Look at the two lobes and the ring, as a volume or as isosurfaces.</source>
        <translation>Densità di probabilità dell&apos;elettrone 3d; griglia regolare, %1, calcolata da TAn. Da guardare: i due lobi e l&apos;anello, come volume o come isosuperfici.</translation>
    </message>
    <message>
        <source>Supersonic flow</source>
        <translation>Flusso supersonico</translation>
    </message>
    <message>
        <source>Density in front of a hemisphere; curvilinear grid, %1, computed by TAn. Look at the bow shock, and at the grid that follows the body.</source>
        <translation>Densità davanti a una semisfera; griglia curvilinea, %1, calcolata da TAn. Da guardare: l&apos;onda d&apos;urto, e la griglia che segue il corpo.</translation>
    </message>
    <message>
        <source>Flow around a cylinder</source>
        <translation>Flusso su cilindro</translation>
    </message>
    <message>
        <source>Pressure of the flow; curvilinear grid that closes on itself, %1, computed by TAn. Look at the front, where the flow is stopped, and at the sides, where it is fastest.</source>
        <translation>Pressione del flusso; griglia curvilinea chiusa su sé stessa, %1, calcolata da TAn. Da guardare: il fronte, dove il flusso si arresta, e i lati, dove è più veloce.</translation>
    </message>
    <message>
        <source>Flow in a duct</source>
        <translation>Flusso in un condotto</translation>
    </message>
    <message>
        <source>Speed in a bent duct; curvilinear grid, %1, computed by TAn. Look at how the flow keeps to the outer wall of the bend.</source>
        <translation>Velocità in un condotto curvo; griglia curvilinea, %1, calcolata da TAn. Da guardare: come il flusso resta sulla parete esterna della curva.</translation>
    </message>
    <message>
        <source>Plate with holes</source>
        <translation>Piastra forata</translation>
    </message>
    <message>
        <source>Stress in a plate with five holes and a closed cavity; irregular mesh, computed by TAn. Look at the boundary, which keeps its holes at every accuracy.</source>
        <translation>Tensione in una piastra con cinque fori e una cavità chiusa; mesh irregolare, calcolata da TAn. Da guardare: il bordo, che conserva i fori a ogni accuratezza.</translation>
    </message>
    <message>
        <source>Scattered points</source>
        <translation>Punti sparsi</translation>
    </message>
    <message>
        <source>Waves that grow finer outwards, sampled at random points in a ball; %1, computed by TAn. Look at the volume: it needs no grid.</source>
        <translation>Onde sempre più fini verso l&apos;esterno, campionate in punti casuali di una sfera; %1, calcolati da TAn. Da guardare: il volume, che non ha bisogno di griglia.</translation>
    </message>
    <message>
        <source>Ripples</source>
        <translation>Increspature</translation>
    </message>
    <message>
        <source>The test signal of Marschner and Lobb; regular grid, %1, computed by TAn. Look at the fine ripples, which vanish first when the error grows.</source>
        <translation>Il segnale di prova di Marschner e Lobb; griglia regolare, %1, calcolata da TAn. Da guardare: le increspature fini, le prime a sparire quando l&apos;errore cresce.</translation>
    </message>
    <message>
        <source>Boundary layer</source>
        <translation>Strato limite</translation>
    </message>
    <message>
        <source>A layer at a wall; rectilinear grid with growing spacing, %1, computed by TAn. Look at how the tetrahedra crowd at the wall.</source>
        <translation>Uno strato presso una parete; griglia rettilinea a passo crescente, %1, calcolata da TAn. Da guardare: come i tetraedri si addensano alla parete.</translation>
    </message>
    <message>
        <source>White noise</source>
        <translation>Rumore bianco</translation>
    </message>
    <message>
        <source>Random values, the worst case for any method; regular grid, %1, computed by TAn. Look at the statistics: even at a large error nearly all points are needed.</source>
        <translation>Valori casuali, il caso peggiore per ogni metodo; griglia regolare, %1, calcolata da TAn. Da guardare: le statistiche, perché anche con un errore grande servono quasi tutti i punti.</translation>
    </message>
</context>
<context>
    <name>Sentence</name>
    <message>
        <source>&apos;%1&apos; does not exist, or its folder may not be entered. Check the name.</source>
        <translation>«%1» non esiste, o la sua cartella non è accessibile. Controllare il nome.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a folder. Choose a file inside it.</source>
        <translation>«%1» è una cartella. Scegliere un file al suo interno.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a device or a pipe. Give a file.</source>
        <translation>«%1» è un dispositivo o una pipe. Scegliere un file.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. The copy may be incomplete: copy the file again.</source>
        <translation>«%1» è vuoto. La copia potrebbe essere incompleta: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2.</source>
        <translation>«%1» non può essere letto: %2.</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: %2</source>
        <translation>«%1» non può essere letto: %2</translation>
    </message>
    <message>
        <source>%1. Check its name and folder.</source>
        <translation>%1. Controllare il nome e la cartella.</translation>
    </message>
    <message>
        <source>%1. Ask its owner for the right to read it.</source>
        <translation>%1. Chiedere al proprietario il permesso di leggerlo.</translation>
    </message>
    <message>
        <source>it is a folder. Name a file in it.</source>
        <translation>è una cartella. Indicare un file al suo interno.</translation>
    </message>
    <message>
        <source>it is not a regular file. Copy its content into one first.</source>
        <translation>non è un file ordinario. Copiarne prima il contenuto in uno.</translation>
    </message>
    <message>
        <source>Cannot open &apos;%1&apos;: too many files are open. Close some of them.</source>
        <translation>«%1» non può essere aperto: troppi file sono aperti. Chiuderne alcuni.</translation>
    </message>
    <message>
        <source>No reader is installed.</source>
        <translation>Nessun lettore è installato.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; cannot be read: %2.</source>
        <translation>Il file «%1» non può essere letto: %2.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; is too large to be what is looked for here.</source>
        <translation>Il file «%1» è troppo grande per essere ciò che si cerca qui.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos;: %2</source>
        <translation>In «%1»: %2</translation>
    </message>
    <message>
        <source>it is empty. Get or make the file again.</source>
        <translation>è vuoto. Procurarsi o creare di nuovo il file.</translation>
    </message>
    <message>
        <source>it changed while it was read. Read it again.</source>
        <translation>è cambiato durante la lettura. Leggerlo di nuovo.</translation>
    </message>
    <message>
        <source>it holds no points.</source>
        <translation>non contiene punti.</translation>
    </message>
    <message>
        <source>it is not a text.</source>
        <translation>non è un testo.</translation>
    </message>
    <message>
        <source>it is of no format that VTK reads.</source>
        <translation>non è di un formato che VTK legge.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. Choose one of these: %2.</source>
        <translation>non ha un vettore «%1». Sceglierne uno fra questi: %2.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. There are: %2.</source>
        <translation>non ha un vettore «%1». Ci sono: %2.</translation>
    </message>
    <message>
        <source>it has no array with a number for each point or cell. Write it with one.</source>
        <translation>non ha vettori con un numero per ogni punto o cella. Scriverlo con uno.</translation>
    </message>
    <message>
        <source>it has no values, of points or of cells.</source>
        <translation>non ha valori, né di punti né di celle.</translation>
    </message>
    <message>
        <source>it should hold %1, but there are only %2. It is cut short, or its description (sizes, type, bytes to skip) is wrong.</source>
        <translation>dovrebbe contenere %1, ma ci sono solo %2. È troncato, o la descrizione (dimensioni, tipo, byte da saltare) è sbagliata.</translation>
    </message>
    <message>
        <source>it should hold %1, but there are %2, %3 too many. Its description is wrong: check the sizes, the type and the bytes to skip.</source>
        <translation>dovrebbe contenere %1, ma ci sono %2, %3 di troppo. La descrizione è sbagliata: controllare dimensioni, tipo e byte da saltare.</translation>
    </message>
    <message>
        <source>%1 samples of type %2, %3 bytes</source>
        <translation>%1 campioni di tipo %2, %3 byte</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 byte</translation>
    </message>
    <message>
        <source>%1 of its %2 samples are NaN or infinite, the first at point (%3). Replace them by numbers first.</source>
        <translation>%1 dei suoi %2 campioni sono NaN o infiniti, il primo nel punto (%3). Sostituirli prima con numeri.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has an unknown format. %2</source>
        <translation>«%1» ha un formato sconosciuto. %2</translation>
    </message>
    <message>
        <source>The manual and &apos;tan info --help&apos; list the files that are read; samples alone, without a header, are read as a raw file.</source>
        <translation>Il manuale e «tan info --help» elencano i file che si possono leggere; campioni soli, senza intestazione, si leggono come file grezzo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is packed. Unpack it first, by &apos;%2&apos;, and open what is in it.</source>
        <translation>«%1» è compresso. Decomprimerlo prima con «%2» e aprire ciò che contiene.</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: %2 (It was unpacked by itself. If it names other files, unpack it beside them: gunzip.)</source>
        <translation>Impossibile leggere «%1»: %2 (È stato decompresso da solo. Se nomina altri file, decomprimerlo accanto a essi: gunzip.)</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and damaged or cut short. The copy may be incomplete: copy the file again.</source>
        <translation>è compresso con gzip, e danneggiato o troncato. La copia potrebbe essere incompleta: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and cannot be unpacked into &apos;%1&apos;: %2. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>è compresso con gzip, e non si può decomprimere in «%1»: %2. Liberare spazio là, impostare TMPDIR su una cartella che ne ha di più, o decomprimerlo a mano (gunzip).</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and unpacks to more than %1, half of the room in &apos;%2&apos;. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>è compresso con gzip, e decompresso supera %1, metà dello spazio in «%2». Liberare spazio là, impostare TMPDIR su una cartella che ne ha di più, o decomprimerlo a mano (gunzip).</translation>
    </message>
    <message>
        <source>VTK says: %1 The file is damaged, incomplete, or of a kind that VTK does not know: copy or export it again.</source>
        <translation>VTK dice: %1 Il file è danneggiato, incompleto o di un tipo che VTK non conosce: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its header asks for %2. It is cut short: copy the file again.</source>
        <translation>ha %1 byte, e la sua intestazione ne chiede %2. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its data file &apos;%1&apos; has %2 bytes, and its header asks for %3. It is cut short: copy the file again.</source>
        <translation>il suo file di dati «%1» ha %2 byte, e l’intestazione ne chiede %3. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its data file &apos;%1&apos; is missing. Copy it into the folder of this one: the two belong together.</source>
        <translation>il suo file di dati «%1» manca. Copiarlo nella cartella di questo: i due vanno insieme.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; is missing. Copy it into the folder of this one: they belong together.</source>
        <translation>il suo file «%1» manca. Copiarlo nella cartella di questo: vanno insieme.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; ends in line %2, before the last %3. It is cut short: copy the file again.</source>
        <translation>il suo file «%1» finisce alla riga %2, prima di tutti i dati (%3). È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its variable &apos;%2&apos; reaches to byte %3. It is cut short, or was not written to its end: copy the file again, or export it again.</source>
        <translation>ha %1 byte, e la sua variabile «%2» arriva al byte %3. È troncato, o non è stato scritto fino in fondo: copiare di nuovo il file, o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>page %1 lies behind its end, at %2 bytes. It is cut short: copy the file again.</source>
        <translation>la pagina %1 sta oltre la sua fine, a %2 byte. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it ends within its header. It is cut short: copy the file again.</source>
        <translation>finisce dentro la sua intestazione. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it ends within its appended data. It is cut short: copy the file again.</source>
        <translation>finisce dentro i dati in coda. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it is a list of files, one for each time step or part. Open one of its files, such as &apos;%1&apos;.</source>
        <translation>è un elenco di file, uno per ogni passo temporale o parte. Aprirne uno, per esempio «%1».</translation>
    </message>
    <message>
        <source>it is a binary UCD file, and only text is read. Write it as text, or as .vtu, for instance with ParaView.</source>
        <translation>è un file UCD binario, e si legge solo il testo. Scriverlo come testo o come .vtu, per esempio con ParaView.</translation>
    </message>
    <message>
        <source>VTK needs more than %1 of memory for it, which files of its size do not need. It is damaged; if not, write it in another format (.vtu, .vti).</source>
        <translation>VTK richiede più di %1 di memoria, che file di questa grandezza non richiedono. È danneggiato; altrimenti scriverlo in un altro formato (.vtu, .vti).</translation>
    </message>
    <message>
        <source>VTK needs more than %1 of memory for it, half of what this machine has. It is damaged, or too large for this machine: take a part of it.</source>
        <translation>VTK richiede più di %1 di memoria, metà di quella di questa macchina. È danneggiato, o troppo grande per questa macchina: prenderne una parte.</translation>
    </message>
    <message>
        <source>VTK needs more than %1 seconds of the processor for it, which files of its size do not need. It is damaged; if not, write it in another format (.vtu, .vti).</source>
        <translation>VTK richiede più di %1 secondi del processore, che file di questa grandezza non richiedono. È danneggiato; altrimenti scriverlo in un altro formato (.vtu, .vti).</translation>
    </message>
    <message>
        <source>VTK needs more memory for it than the %1 that programs may take here. Raise the limit (ulimit -v).</source>
        <translation>VTK richiede più memoria dei %1 che i programmi possono prendere qui. Alzare il limite (ulimit -v).</translation>
    </message>
    <message>
        <source>the system ended VTK, which it does when memory runs out. Close other programs, or take a part of the file.</source>
        <translation>il sistema ha terminato VTK, come fa quando la memoria finisce. Chiudere altri programmi, o prendere una parte del file.</translation>
    </message>
    <message>
        <source>VTK has waited for its disk for minutes. See whether the disk answers, or copy the file to another one.</source>
        <translation>VTK ha atteso per minuti il suo disco. Verificare che il disco risponda, o copiare il file su un altro.</translation>
    </message>
    <message>
        <source>There are not enough memory, processes or open files to start the VTK readers (%1). Close other programs, or raise the limit (ulimit).</source>
        <translation>Memoria, processi o file aperti non bastano per avviare i lettori VTK (%1). Chiudere altri programmi, o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>The file ends without an end of line: if it was cut short there, its last number is wrong.</source>
        <translation>Il file finisce senza fine riga: se è stato troncato lì, il suo ultimo numero è sbagliato.</translation>
    </message>
    <message>
        <source>1 cell is called linear and has the corners of a quadratic one: it was taken as such.</source>
        <translation>1 cella è detta lineare e ha i vertici di una quadratica: è stata presa come tale.</translation>
    </message>
    <message>
        <source>%1 cells are called linear and have the corners of quadratic ones: they were taken as such.</source>
        <translation>%1 celle sono dette lineari e hanno i vertici di quadratiche: sono state prese come tali.</translation>
    </message>
    <message>
        <source>VTK&apos;s reader crashed. The file is damaged, larger than memory, or of a kind that VTK reads badly. Export it again, or in another format (.vtu, .vti).</source>
        <translation>Il lettore di VTK si è arrestato in modo anomalo. Il file è danneggiato, più grande della memoria, o di un tipo che VTK legge male. Esportarlo di nuovo, o in un altro formato (.vtu, .vti).</translation>
    </message>
    <message>
        <source>The VTK readers are not installed. Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; where the file lies (of a build of your own: build it anew after &apos;apt install libvtk9-dev&apos;), or convert the file to NRRD or CSV.</source>
        <translation>I lettori VTK non sono installati. Installare il pacchetto tan-vtk-readers, fornito con TAn: «apt install ./tan-vtk-readers_*.deb» dove si trova il file (se compilato da sé: ricompilare dopo «apt install libvtk9-dev»), o convertire il file in NRRD o CSV.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2. Copy the file again, or build it again.</source>
        <translation>«%1» è danneggiato: %2. Copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>its header makes no sense</source>
        <translation>la sua intestazione non ha senso</translation>
    </message>
    <message>
        <source>the checksum of its header is wrong</source>
        <translation>la somma di controllo della sua intestazione è sbagliata</translation>
    </message>
    <message>
        <source>the checksum of its text is wrong</source>
        <translation>la somma di controllo del suo testo è sbagliata</translation>
    </message>
    <message>
        <source>the checksum of section &apos;%1&apos; is wrong</source>
        <translation>la somma di controllo della sezione «%1» è sbagliata</translation>
    </message>
    <message>
        <source>it has %1 bytes and should have %2</source>
        <translation>ha %1 byte e dovrebbe averne %2</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; is missing</source>
        <translation>manca la sezione «%1»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is cut short: it has %2 bytes and should have %3. Copy the file again, or build it again.</source>
        <translation>«%1» è troncato: ha %2 byte e dovrebbe averne %3. Copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. Models are made by &apos;tan build&apos;.</source>
        <translation>«%1» è vuoto. I modelli si costruiscono da insiemi di dati.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a TAn model: it does not begin like one. Models are made by &apos;tan build&apos;.</source>
        <translation>«%1» non è un modello TAn: non comincia come tale. I modelli si costruiscono da insiemi di dati.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was written with the other byte order. Build it again on this machine.</source>
        <translation>«%1» è scritto nell&apos;altro ordine dei byte. Ricostruirlo su questo computer.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has format version %2; this program reads up to version %3. Install a later version of TAn.</source>
        <translation>«%1» ha la versione %2 del formato; questo programma legge fino alla versione %3. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open. Open it again; if that fails, copy the file again, or build it again.</source>
        <translation>«%1» è stato troncato o cambiato mentre era aperto. Aprirlo di nuovo; se non riesce, copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open, so that what was made of it would be wrong. Open it again; if that fails, get or make the file again.</source>
        <translation>«%1» è stato troncato o cambiato mentre era aperto, perciò ciò che se ne è ricavato sarebbe sbagliato. Aprirlo di nuovo; se non riesce, procurarsi o creare di nuovo il file.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2. %3</source>
        <translation>«%1» non può essere scritto: %2. %3</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; does not exist: create it or choose another.</source>
        <translation>La cartella «%1» non esiste: crearla o sceglierne un&apos;altra.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a folder: choose another.</source>
        <translation>«%1» non è una cartella: sceglierne un&apos;altra.</translation>
    </message>
    <message>
        <source>It is a folder: name a file in it.</source>
        <translation>È una cartella: indicare un file al suo interno.</translation>
    </message>
    <message>
        <source>Choose another folder, or change the permissions of this one.</source>
        <translation>Scegliere un&apos;altra cartella, o cambiare i permessi di questa.</translation>
    </message>
    <message>
        <source>Choose a folder on a disk that can be written.</source>
        <translation>Scegliere una cartella su un disco scrivibile.</translation>
    </message>
    <message>
        <source>Free some space or choose another disk.</source>
        <translation>Liberare spazio o scegliere un altro disco.</translation>
    </message>
    <message>
        <source>Choose a disk that allows larger files, or raise the limit (ulimit -f).</source>
        <translation>Scegliere un disco che permetta file più grandi, o alzare il limite (ulimit -f).</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Scegliere un nome più corto.</translation>
    </message>
    <message>
        <source>Choose another folder or disk.</source>
        <translation>Scegliere un&apos;altra cartella o un altro disco.</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>non è un file ordinario</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Scegliere un altro nome.</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>il file è di sola lettura</translation>
    </message>
    <message>
        <source>Choose another name, or make it writable.</source>
        <translation>Scegliere un altro nome, o renderlo scrivibile.</translation>
    </message>
    <message>
        <source>it does not name a file</source>
        <translation>non indica un file</translation>
    </message>
    <message>
        <source>Name a file.</source>
        <translation>Indicare un file.</translation>
    </message>
    <message>
        <source>Cannot work in &apos;%1&apos;: %2. %3</source>
        <translation>Non si può lavorare in «%1»: %2. %3</translation>
    </message>
    <message>
        <source>another program is building this model</source>
        <translation>un altro programma sta costruendo questo modello</translation>
    </message>
    <message>
        <source>Wait for it, or give the model another name.</source>
        <translation>Aspettarlo, o dare al modello un altro nome.</translation>
    </message>
    <message>
        <source>Choose another folder for the model.</source>
        <translation>Scegliere un&apos;altra cartella per il modello.</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>File o cartella inesistente</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permesso negato</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Operazione non permessa</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Errore di input/output</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>Memoria insufficiente</translation>
    </message>
    <message>
        <source>Resource temporarily unavailable</source>
        <translation>Risorsa temporaneamente non disponibile</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Dispositivo o risorsa occupati</translation>
    </message>
    <message>
        <source>Invalid cross-device link</source>
        <translation>Su un altro dispositivo</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Non è una cartella</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>È una cartella</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>Argomento non valido</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Troppi file aperti</translation>
    </message>
    <message>
        <source>Too many open files in system</source>
        <translation>Troppi file aperti nel sistema</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>File troppo grande</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Spazio esaurito sul disco</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>File system in sola lettura</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Nome del file troppo lungo</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Troppi livelli di collegamenti simbolici</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Quota disco superata</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Il file non esiste più sul server</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is the input &apos;%2&apos;. Give the output another name.</source>
        <translation>Il risultato «%1» è l&apos;origine «%2». Dare al risultato un altro nome.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; exists and is no TAn model, so it is not overwritten. Give the model another name, or remove that file first.</source>
        <translation>«%1» esiste e non è un modello TAn, perciò non viene sovrascritto. Dare al modello un altro nome, o rimuovere prima quel file.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written: %2. Choose another place.</source>
        <translation>«%1» non può essere scritto: %2. Scegliere un altro posto.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; for samples cannot be made: %2. Make it writable, or free some space.</source>
        <translation>La cartella «%1» per gli esempi non può essere creata: %2. Renderla scrivibile, o liberare spazio.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ends in none of .vtu, .vtk and .ply, the formats in which meshes are written, nor of .vtp, .stl, .obj and .glb, for their boundary alone. Choose one of these endings.</source>
        <translation>«%1» non termina né in .vtu, .vtk o .ply, i formati in cui si scrivono le mesh, né in .vtp, .stl, .obj o .glb, per il solo bordo. Scegliere una di queste estensioni.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ends in none of .vtp, .vtk, .vtu, .ply, .stl, .obj and .glb, the formats in which surfaces are written. Choose one of these endings.</source>
        <translation>«%1» non termina in .vtp, .vtk, .vtu, .ply, .stl, .obj o .glb, i formati in cui si scrivono le superfici. Scegliere una di queste estensioni.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ends in neither .csv nor .json, the formats in which statistics are written. Choose one of these endings.</source>
        <translation>«%1» non termina né in .csv né in .json, i formati in cui si scrivono le statistiche. Scegliere una di queste estensioni.</translation>
    </message>
    <message>
        <source>There is no surface to save: add an isovalue, or show one.</source>
        <translation>Non c&apos;è alcuna superficie da salvare: aggiungere un isovalore, o mostrarne uno.</translation>
    </message>
    <message>
        <source>A film needs two key frames at least. Add another view.</source>
        <translation>Un filmato richiede almeno due fotogrammi chiave. Aggiungere un&apos;altra vista.</translation>
    </message>
    <message>
        <source>The video could not be made: %1 says &quot;%2&quot;. Choose another format, or PNG pictures.</source>
        <translation>Non è stato possibile creare il video: %1 dice «%2». Scegliere un altro formato, o immagini PNG.</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos;.</source>
        <translation>La memoria non basta per scrivere «%1».</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos;. Close other programs.</source>
        <translation>La memoria non basta per scrivere «%1». Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>Not enough memory to read &apos;%1&apos;. Close other programs.</source>
        <translation>La memoria non basta per leggere «%1». Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>There is not enough memory for the mesh at this accuracy. Choose a coarser one, or close other programs.</source>
        <translation>La memoria non basta per la mesh a questa accuratezza. Sceglierne una minore, o chiudere altri programmi.</translation>
    </message>
    <message>
        <source>There is not enough memory for this mesh. Ask for a larger error, a smaller focus or a budget.</source>
        <translation>La memoria non basta per questa mesh. Scegliere un errore maggiore, un focus più piccolo o un limite.</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh of the focus. Choose a larger error or a smaller focus.</source>
        <translation>La memoria non basta per la mesh del focus. Scegliere un errore maggiore o un focus più piccolo.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>La memoria non basta per un&apos;immagine di queste dimensioni.</translation>
    </message>
    <message>
        <source>Not enough memory for a picture of this size and scene. Make the picture smaller or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per un&apos;immagine di queste dimensioni e di questa scena. Rimpicciolire l&apos;immagine o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per l&apos;isosuperficie. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurfaces. Show fewer of them or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per le isosuperfici. Mostrarne meno o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>Not enough memory to draw this mesh as a volume. Close other programs or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per disegnare questa mesh come volume. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>Not enough memory for this part. Take a smaller one.</source>
        <translation>La memoria non basta per questa parte. Prenderne una più piccola.</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh. Take a part of it.</source>
        <translation>La memoria non basta per la mesh. Prenderne una parte.</translation>
    </message>
    <message>
        <source>Not enough memory to refine this lattice. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>La memoria non basta per raffinare questo reticolo. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei dati.</translation>
    </message>
    <message>
        <source>Not enough memory to refine this grid. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>La memoria non basta per raffinare questa griglia. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei dati.</translation>
    </message>
    <message>
        <source>Not enough memory to refine these points. Close other programs, use a machine with more memory, or take a part of the points.</source>
        <translation>La memoria non basta per raffinare questi punti. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei punti.</translation>
    </message>
    <message>
        <source>Not enough memory to decimate this mesh. Close other programs, use a machine with more memory, or take a part of the data.</source>
        <translation>La memoria non basta per decimare questa mesh. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei dati.</translation>
    </message>
    <message>
        <source>The finest error (%1 %) is larger than the error at which to stop (%2 %). Choose a smaller finest error, or 0 to keep everything.</source>
        <translation>L&apos;errore minimo (%1 %) è maggiore dell&apos;errore a cui fermarsi (%2 %). Scegliere un errore minimo più piccolo, o 0 per tenere tutto.</translation>
    </message>
    <message>
        <source>Decimation of %1 takes about %2 of memory, and this machine has %3. Take a region of it or fewer samples, or, of a lattice or grid, refine it instead.</source>
        <translation>La decimazione di %1 richiede circa %2 di memoria, e questo computer ne ha %3. Prenderne una regione o meno campioni, oppure, se è un reticolo o una griglia, usare il raffinamento.</translation>
    </message>
    <message>
        <source>%1 points and %2 tetrahedra</source>
        <translation>%1 punti e %2 tetraedri</translation>
    </message>
    <message>
        <source>The memory of this machine is not enough for &apos;%1&apos; here. Close other programs, or give it smaller data.</source>
        <translation>La memoria di questo computer qui non basta per «%1». Chiudere altri programmi, o dargli dati più piccoli.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; failed: %2. This is a mistake in the plugin; tell its author.</source>
        <translation>Il plugin «%1» ha fallito: %2. È un errore del plugin; segnalarlo all&apos;autore.</translation>
    </message>
    <message>
        <source>The build was stopped before there was a mesh of known error, so there is nothing to keep.</source>
        <translation>La costruzione è stata fermata prima che ci fosse una mesh di errore noto, perciò non c&apos;è nulla da conservare.</translation>
    </message>
    <message>
        <source>The build needs about %1 on the disk of &apos;%2&apos; (%3), and %4 are free. Free some space, choose another disk or ask for a larger error.</source>
        <translation>La costruzione richiede circa %1 sul disco di «%2» (%3), e %4 sono liberi. Liberare spazio, scegliere un altro disco o un errore maggiore.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; does not accept &apos;%2&apos;: %3</source>
        <translation>«%1» non accetta «%2»: %3</translation>
    </message>
    <message>
        <source>The block size &apos;%1&apos; is neither &quot;automatic&quot; nor &quot;none&quot; nor a number of cells of at least 1.</source>
        <translation>La dimensione «%1» dei blocchi non è né «automatic» né «none» né un numero di celle da 1.</translation>
    </message>
    <message>
        <source>The weight &apos;%1&apos; cannot be used: %2.</source>
        <translation>Il peso «%1» non è utilizzabile: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>«%1» non è un numero</translation>
    </message>
    <message>
        <source>it has %1 numbers, and the form is %2</source>
        <translation>ha %1 numeri, e la forma è %2</translation>
    </message>
    <message>
        <source>its reach is %1 and must be at least 0</source>
        <translation>la sua portata è %1 e deve essere almeno 0</translation>
    </message>
    <message>
        <source>its reach is %1 and must be above 0</source>
        <translation>la sua portata è %1 e deve essere maggiore di 0</translation>
    </message>
    <message>
        <source>its floor is %1 and must be from %2 to 1</source>
        <translation>il suo minimo è %1 e deve essere da %2 a 1</translation>
    </message>
    <message>
        <source>a weight begins with &apos;point:&apos;, &apos;box:&apos; or &apos;value:&apos;</source>
        <translation>un peso comincia con «point:», «box:» o «value:»</translation>
    </message>
    <message>
        <source>its first corner must be the smaller one along every axis</source>
        <translation>il suo primo vertice deve essere il minore lungo ogni asse</translation>
    </message>
    <message>
        <source>The mesh has %1. Repair the mesh in the program that made it.</source>
        <translation>La mesh ha %1. Correggerla nel programma che l&apos;ha creata.</translation>
    </message>
    <message>
        <source>No cell of the mesh has a volume: nothing is left.</source>
        <translation>Nessuna cella della mesh ha un volume: non resta nulla.</translation>
    </message>
    <message>
        <source>The coarsest mesh of &apos;%1&apos; has %2 tetrahedra, more than the budget of %3. Allow at least as many.</source>
        <translation>La mesh più grossolana di «%1» ha %2 tetraedri, più del limite di %3. Permetterne almeno altrettanti.</translation>
    </message>
    <message>
        <source>The coarsest mesh has %1 tetrahedra, more than the budget of %2. Allow at least as many.</source>
        <translation>La mesh più grossolana ha %1 tetraedri, più del limite di %2. Permetterne almeno altrettanti.</translation>
    </message>
    <message>
        <source>The error in the focus is larger than that outside. Swap them.</source>
        <translation>L&apos;errore nel focus è maggiore di quello esterno. Scambiarli.</translation>
    </message>
    <message>
        <source>The mesh of the focus became too large. Choose a larger error or a smaller focus.</source>
        <translation>La mesh del focus è diventata troppo grande. Scegliere un errore maggiore o un focus più piccolo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no clip plane: give four numbers nx,ny,nz,offset, the first three not all zero; points with nx x + ny y + nz z &gt;= offset are shown.</source>
        <translation>«%1» non è un piano di taglio: dare quattro numeri nx,ny,nz,distanza, i primi tre non tutti nulli; si mostrano i punti con nx x + ny y + nz z &gt;= distanza.</translation>
    </message>
    <message>
        <source>The model of the session cannot be opened. %1</source>
        <translation>Il modello della sessione non può essere aperto. %1</translation>
    </message>
    <message>
        <source>%1: The session cannot be read: %2</source>
        <translation>%1: La sessione non può essere letta: %2</translation>
    </message>
    <message>
        <source>its &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation>«format» non è «%1».</translation>
    </message>
    <message>
        <source>this program knows version %1 of sessions only.</source>
        <translation>questo programma conosce solo la versione %1 delle sessioni.</translation>
    </message>
    <message>
        <source>it names no model in &quot;model.path&quot;.</source>
        <translation>non indica un modello in «model.path».</translation>
    </message>
    <message>
        <source>The transfer function cannot be read: %1</source>
        <translation>La funzione di trasferimento non può essere letta: %1</translation>
    </message>
    <message>
        <source>The transfer function cannot be read. %1</source>
        <translation>La funzione di trasferimento non può essere letta. %1</translation>
    </message>
    <message>
        <source>The ParaView preset cannot be read: %1</source>
        <translation>La preimpostazione di ParaView non può essere letta: %1</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be used: %2.</source>
        <translation>La preimpostazione «%1» non può essere usata: %2.</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be changed: %2. Check the rights of its folder, and that there is space.</source>
        <translation>La preimpostazione «%1» non può essere modificata: %2. Controllare i permessi della cartella, e che ci sia spazio.</translation>
    </message>
    <message>
        <source>Not valid JSON: %1</source>
        <translation>JSON non valido: %1</translation>
    </message>
    <message>
        <source>This is no camera. %1</source>
        <translation>Questa non è una camera. %1</translation>
    </message>
    <message>
        <source>This is no camera: it holds no JSON object, in braces.</source>
        <translation>Questa non è una camera: non contiene un oggetto JSON, fra graffe.</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera %2 (%3).</source>
        <translation>La chiave «%1» della camera %2 (%3).</translation>
    </message>
    <message>
        <source>is no number from %1 to %2</source>
        <translation>non è un numero da %1 a %2</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>non è né true né false</translation>
    </message>
    <message>
        <source>is not a list of three numbers</source>
        <translation>non è un elenco di tre numeri</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>non è nota</translation>
    </message>
    <message>
        <source>expected a value (%1).</source>
        <translation>manca un valore (%1).</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>riga %1, colonna %2</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for a picture of this size. Make it smaller, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per un&apos;immagine di queste dimensioni. Rimpicciolirla, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for this picture. Make it smaller, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per questa immagine. Rimpicciolirla, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for this volume. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per questo volume. Ridurre l&apos;accuratezza della mesh, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The graphics card has not enough memory for this surface. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per questa superficie. Ridurre l&apos;accuratezza della mesh, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The OpenGL context cannot be used, perhaps because the graphics card was reset. Use the CPU back end.</source>
        <translation>Il contesto OpenGL non è utilizzabile, forse perché la scheda grafica è stata reinizializzata. Far disegnare il processore.</translation>
    </message>
    <message>
        <source>The OpenGL driver has version %1; TAn needs 3.3. Use the CPU back end, or another driver.</source>
        <translation>Il driver OpenGL ha la versione %1; TAn richiede la 3.3. Far disegnare il processore, o usare un altro driver.</translation>
    </message>
    <message>
        <source>OpenGL cuts scenes by at most %1 planes. Take fewer, or use the CPU back end.</source>
        <translation>OpenGL taglia le scene con al più %1 piani. Usarne meno, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which is not here or cannot be used. Install it.</source>
        <translation>Richiede il plugin «%1», che manca o non è utilizzabile. Installarlo.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which cannot be used: %2</source>
        <translation>Richiede il plugin «%1», che non è utilizzabile: %2</translation>
    </message>
    <message>
        <source>It is not a plugin, or is damaged: %1 Install it again, or remove the file.</source>
        <translation>Non è un plugin, o è danneggiato: %1 Installarlo di nuovo, o rimuovere il file.</translation>
    </message>
    <message>
        <source>Another plugin has the same id and was found first: %1. Remove one of the two.</source>
        <translation>Un altro plugin ha lo stesso identificativo ed è stato trovato prima: %1. Rimuovere uno dei due.</translation>
    </message>
    <message>
        <source>The library %1 is missing. %2</source>
        <translation>Manca la libreria %1. %2</translation>
    </message>
    <message>
        <source>It was built with Qt %1, and this program runs with Qt %2. Install a build of the plugin for this Qt.</source>
        <translation>È stato compilato con Qt %1, e questo programma usa Qt %2. Installare il plugin per questo Qt.</translation>
    </message>
    <message>
        <source>A part of %1 of the %2 points.</source>
        <translation>Una parte di %1 dei %2 punti.</translation>
    </message>
    <message>
        <source>1 tetrahedron inside the region was left out: it touches the others only at a vertex or an edge.</source>
        <translation>1 tetraedro nella regione è stato omesso: tocca gli altri solo in un vertice o uno spigolo.</translation>
    </message>
    <message>
        <source>%1 tetrahedra inside the region were left out: they touch the others only at a vertex or an edge.</source>
        <translation>%1 tetraedri nella regione sono stati omessi: toccano gli altri solo in un vertice o uno spigolo.</translation>
    </message>
    <message>
        <source>The values belong to cells: each point got the mean of the cells around it.</source>
        <translation>I valori appartengono alle celle: ogni punto ha ricevuto la media delle celle attorno.</translation>
    </message>
    <message>
        <source>The values of the cells were brought to the points, as the mean of the cells around.</source>
        <translation>I valori delle celle sono stati portati ai punti, come media delle celle attorno.</translation>
    </message>
    <message>
        <source>All cells had inverted orientation and were corrected.</source>
        <translation>Tutte le celle avevano orientamento inverso e sono state corrette.</translation>
    </message>
    <message>
        <source>What joins its points (lines, polygons) was left out: they are scattered points.</source>
        <translation>Ciò che unisce i suoi punti (linee, poligoni) è stato omesso: sono punti sparsi.</translation>
    </message>
    <message>
        <source>A grid with cells that are blanked out, or whose values are no numbers: an irregular mesh without them.</source>
        <translation>Una griglia con celle escluse, o i cui valori non sono numeri: una mesh irregolare senza di esse.</translation>
    </message>
    <message>
        <source>%1 of its parts have no &apos;%2&apos; and were left out.</source>
        <translation>%1 delle sue parti non hanno «%2» e sono state omesse.</translation>
    </message>
    <message>
        <source>%1 of its parts are no irregular meshes and were left out.</source>
        <translation>%1 delle sue parti non sono mesh irregolari e sono state omesse.</translation>
    </message>
    <message>
        <source>It contains %1 parts; this is the one called &apos;%2&apos;. Choose another one with &apos;part&apos;.</source>
        <translation>Contiene %1 parti; questa è quella chiamata «%2». Un&apos;altra si sceglie con «Parte».</translation>
    </message>
    <message>
        <source>Time step %1 of %2. Choose another one with &apos;time&apos;.</source>
        <translation>Passo temporale %1 di %2. Un altro si sceglie con «Passo temporale».</translation>
    </message>
    <message>
        <source>%1 points whose value is no number were left out.</source>
        <translation>%1 punti il cui valore non è un numero sono stati omessi.</translation>
    </message>
    <message>
        <source>The samples were multiplied and shifted as the header of the file asks.</source>
        <translation>I campioni sono stati moltiplicati e traslati come chiede l&apos;intestazione del file.</translation>
    </message>
    <message>
        <source>Its 64-bit integers became floating-point numbers of 53 bits.</source>
        <translation>I suoi interi a 64 bit sono diventati numeri in virgola mobile a 53 bit.</translation>
    </message>
    <message>
        <source>VTK says: %1</source>
        <translation>VTK dice: %1</translation>
    </message>
    <message>
        <source>1 cell is a vertex, line or polygon without volume and not part of the mesh.</source>
        <translation>1 cella è un vertice, una linea o un poligono senza volume e non fa parte della mesh.</translation>
    </message>
    <message>
        <source>%1 cells are a vertex, line or polygon without volume and not part of the mesh.</source>
        <translation>%1 celle sono vertici, linee o poligoni senza volume e non fanno parte della mesh.</translation>
    </message>
    <message>
        <source>1 cell is blanked out in the file: a hole.</source>
        <translation>1 cella è esclusa nel file: un foro.</translation>
    </message>
    <message>
        <source>%1 cells are blanked out in the file: a hole.</source>
        <translation>%1 celle sono escluse nel file: un foro.</translation>
    </message>
    <message>
        <source>1 cell has a value that is not finite and became a hole.</source>
        <translation>1 cella ha un valore non finito ed è diventata un foro.</translation>
    </message>
    <message>
        <source>%1 cells have a value that is not finite and became a hole.</source>
        <translation>%1 celle hanno un valore non finito e sono diventate un foro.</translation>
    </message>
    <message>
        <source>1 cell names a corner twice, has no volume and was left out.</source>
        <translation>1 cella nomina due volte un vertice, non ha volume ed è stata omessa.</translation>
    </message>
    <message>
        <source>%1 cells name a corner twice, have no volume and were left out.</source>
        <translation>%1 celle nominano due volte un vertice, non hanno volume e sono state omesse.</translation>
    </message>
    <message>
        <source>1 cell without volume was left out.</source>
        <translation>1 cella senza volume è stata omessa.</translation>
    </message>
    <message>
        <source>%1 cells without volume were left out.</source>
        <translation>%1 celle senza volume sono state omesse.</translation>
    </message>
    <message>
        <source>1 cell had inverted orientation and was corrected.</source>
        <translation>1 cella aveva orientamento inverso ed è stata corretta.</translation>
    </message>
    <message>
        <source>%1 cells had inverted orientation and were corrected.</source>
        <translation>%1 celle avevano orientamento inverso e sono state corrette.</translation>
    </message>
    <message>
        <source>1 point on the place of another one joined with it.</source>
        <translation>1 punto nel posto di un altro è stato unito a esso.</translation>
    </message>
    <message>
        <source>%1 points on the place of another one joined with it.</source>
        <translation>%1 punti nel posto di un altro sono stati uniti a esso.</translation>
    </message>
    <message>
        <source>1 place had different values and got their mean.</source>
        <translation>1 posto aveva valori diversi e ha ricevuto la loro media.</translation>
    </message>
    <message>
        <source>%1 places had different values and got their mean.</source>
        <translation>%1 posti avevano valori diversi e hanno ricevuto la loro media.</translation>
    </message>
    <message>
        <source>1 node in the middle of an edge or face was left out: not all cells there have them, or cells bend too much.</source>
        <translation>1 nodo nel mezzo di uno spigolo o di una faccia è stato omesso: non tutte le celle lì lo hanno, o si incurvano troppo.</translation>
    </message>
    <message>
        <source>%1 nodes in the middle of edges and faces were left out: not all cells there have them, or cells bend too much.</source>
        <translation>%1 nodi nel mezzo di spigoli e facce sono stati omessi: non tutte le celle lì li hanno, o si incurvano troppo.</translation>
    </message>
    <message>
        <source>1 cell was cut along other diagonals, because the faces are not flat.</source>
        <translation>1 cella è stata divisa lungo altre diagonali, perché le facce non sono piane.</translation>
    </message>
    <message>
        <source>%1 cells were cut along other diagonals, because the faces are not flat.</source>
        <translation>%1 celle sono state divise lungo altre diagonali, perché le facce non sono piane.</translation>
    </message>
    <message>
        <source>1 cell was left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>1 cella è stata omessa: troppo deformata per essere divisa in tetraedri senza un nuovo punto.</translation>
    </message>
    <message>
        <source>%1 cells were left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>%1 celle sono state omesse: troppo deformate per essere divise in tetraedri senza un nuovo punto.</translation>
    </message>
    <message>
        <source>1 tetrahedron was there twice.</source>
        <translation>1 tetraedro c&apos;era due volte.</translation>
    </message>
    <message>
        <source>%1 tetrahedra were there twice.</source>
        <translation>%1 tetraedri c&apos;erano due volte.</translation>
    </message>
    <message>
        <source>1 tetrahedron was left out where parts of the mesh touched in an edge or a point only.</source>
        <translation>1 tetraedro è stato omesso dove parti della mesh si toccavano solo in uno spigolo o in un punto.</translation>
    </message>
    <message>
        <source>%1 tetrahedra were left out where parts of the mesh touched in an edge or a point only.</source>
        <translation>%1 tetraedri sono stati omessi dove parti della mesh si toccavano solo in uno spigolo o in un punto.</translation>
    </message>
    <message>
        <source>1 point is of no cell: left out.</source>
        <translation>1 punto non è di alcuna cella: omesso.</translation>
    </message>
    <message>
        <source>%1 points are of no cell: left out.</source>
        <translation>%1 punti non sono di alcuna cella: omessi.</translation>
    </message>
    <message>
        <source>1 incomplete row was skipped.</source>
        <translation>1 riga incompleta è stata saltata.</translation>
    </message>
    <message>
        <source>%1 incomplete rows were skipped.</source>
        <translation>%1 righe incomplete sono state saltate.</translation>
    </message>
    <message>
        <source>1 tetrahedron that is flat or inverted, one at %1</source>
        <translation>1 tetraedro piatto o invertito, in %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that are flat or inverted, one at %2</source>
        <translation>%1 tetraedri piatti o invertiti, per esempio in %2</translation>
    </message>
    <message>
        <source>1 tetrahedron at a face that three or more share, one at %1</source>
        <translation>1 tetraedro su una faccia che tre o più condividono, in %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra at faces that three or more share, one at %2</source>
        <translation>%1 tetraedri su facce che tre o più condividono, per esempio in %2</translation>
    </message>
    <message>
        <source>1 tetrahedron that overlaps its neighbour, one at %1</source>
        <translation>1 tetraedro che si sovrappone al vicino, in %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that overlap a neighbour on the same side of a face, one at %2</source>
        <translation>%1 tetraedri che si sovrappongono a un vicino dallo stesso lato di una faccia, per esempio in %2</translation>
    </message>
    <message>
        <source>1 edge in which parts of it only touch, one at %1</source>
        <translation>1 spigolo in cui le sue parti si toccano soltanto, in %1</translation>
    </message>
    <message>
        <source>%1 edges in which parts of it only touch, one at %2</source>
        <translation>%1 spigoli in cui le sue parti si toccano soltanto, per esempio in %2</translation>
    </message>
    <message>
        <source>1 point in which parts of it only touch, one at %1</source>
        <translation>1 punto in cui le sue parti si toccano soltanto, in %1</translation>
    </message>
    <message>
        <source>%1 points in which parts of it only touch, one at %2</source>
        <translation>%1 punti in cui le sue parti si toccano soltanto, per esempio in %2</translation>
    </message>
    <message>
        <source>1 part inside another part, one at %1</source>
        <translation>1 parte dentro un&apos;altra, in %1</translation>
    </message>
    <message>
        <source>%1 parts inside other parts, one at %2</source>
        <translation>%1 parti dentro altre, per esempio in %2</translation>
    </message>
    <message>
        <source>Not enough memory for the boundary of the mesh. Lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per il contorno della mesh. Ridurre la precisione della mesh.</translation>
    </message>
    <message>
        <source>The mesh has too many tetrahedra for its boundary to be shown. Lower the accuracy of the mesh.</source>
        <translation>La mesh ha troppi tetraedri perché se ne mostri il contorno. Ridurre la precisione della mesh.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be written to, so that the view cannot be kept. Make room there, or save the session.</source>
        <translation>Non si può scrivere nella cartella «%1», quindi la vista non può essere conservata. Liberare spazio lì, o salvare la sessione.</translation>
    </message>
    <message>
        <source>%1. Close other programs, or raise the limit (ulimit).</source>
        <translation>%1. Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limit (ulimit).</source>
        <translation>Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>it holds something else</source>
        <translation>contiene qualcos&apos;altro</translation>
    </message>
    <message>
        <source>Give the model another name, or move that folder away.</source>
        <translation>Dare al modello un altro nome o spostare quella cartella.</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>è un collegamento</translation>
    </message>
    <message>
        <source>Give the model another name, or move that link away.</source>
        <translation>Dare al modello un altro nome o spostare quel collegamento.</translation>
    </message>
    <message>
        <source>Cannot make a temporary file in &apos;%1&apos;: %2. %3</source>
        <translation>Impossibile creare un file temporaneo in «%1»: %2. %3</translation>
    </message>
    <message>
        <source>A temporary file in &apos;%1&apos; cannot be used: %2. %3</source>
        <translation>Un file temporaneo in «%1» non può essere usato: %2. %3</translation>
    </message>
    <message>
        <source>The memory of this machine is not enough for this. Close other programs, or raise the limit (ulimit).</source>
        <translation>La memoria di questo computer non basta. Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>This machine can start no more threads now. Close other programs, or raise the limit (ulimit).</source>
        <translation>Questo computer non può avviare altri thread in questo momento. Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>Not all plugins can be loaded now: %1. Close other programs, or raise the limit (ulimit).</source>
        <translation>In questo momento non è possibile caricare tutti i plugin: %1. Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
</context>
<context>
    <name>Statistics</name>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>± value</source>
        <translation>± valore</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vertici</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedri</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Quota</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memoria</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valori</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>Total vertices</source>
        <translation>Vertici in totale</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Mostrato</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 vertici, %2 tetraedri</translation>
    </message>
    <message>
        <source>Guaranteed</source>
        <translation>Garantito</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangoli</translation>
    </message>
    <message>
        <source>Extraction</source>
        <translation>Estrazione</translation>
    </message>
    <message>
        <source>Preparation</source>
        <translation>Preparazione</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Un&apos;immagine</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Tagliati</translation>
    </message>
    <message>
        <source>Visibility cycles</source>
        <translation>Cicli di visibilità</translation>
    </message>
    <message>
        <source>%1, in which cells are drawn by their distance</source>
        <translation>%1, in cui le celle sono disegnate secondo la distanza</translation>
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
        <translation>%1 vertici</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 vertice</translation>
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
        <translation>Errore in percento dell&apos;intervallo dei valori</translation>
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
        <translation>Errore, % dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Tetrahedra against error</source>
        <translation>Tetraedri rispetto all&apos;errore</translation>
    </message>
    <message>
        <source>Number of tetrahedra needed for each error. Click, drag or use the arrow keys to choose the accuracy.</source>
        <translation>Numero di tetraedri necessari per ogni errore. Fare clic, trascinare o usare i tasti freccia per scegliere l&apos;accuratezza.</translation>
    </message>
    <message>
        <source>%1 tetrahedra at an error of %2</source>
        <translation>%1 tetraedri con un errore di %2</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedri</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyPanel</name>
    <message>
        <source>%1 of all</source>
        <translation>%1 del totale</translation>
    </message>
    <message>
        <source>Error of %1 of the value range</source>
        <translation>Errore di %1 dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Every sample exact</source>
        <translation>Ogni campione esatto</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vertici</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedri</translation>
    </message>
    <message>
        <source>This model was built down to an error of %1; it has nothing finer.</source>
        <translation>Questo modello è stato costruito fino a un errore di %1; non ha nulla di più fine.</translation>
    </message>
    <message>
        <source>of the range
± %1</source>
        <translation>dell&apos;intervallo
± %1</translation>
    </message>
    <message>
        <source>What the percentage means in units of the data. Of curvilinear data it holds for the error and for the warping: the distance of the mesh from the grid, in percent of the diagonal of the box around it.</source>
        <translation>Che cosa significa la percentuale nelle unità dei dati. Per dati curvilinei vale per l&apos;errore e per la deformazione: la distanza della mesh dalla griglia, in percento della diagonale del parallelepipedo che la contiene.</translation>
    </message>
    <message>
        <source>Bu&amp;dget</source>
        <translation>&amp;Limite</translation>
    </message>
    <message>
        <source>The smallest mesh with this error</source>
        <translation>La mesh più piccola con questo errore</translation>
    </message>
    <message>
        <source>The best mesh with so many tetrahedra. A focus keeps its proportion to the rest.</source>
        <translation>La mesh migliore con tanti tetraedri. Un focus conserva la sua proporzione col resto.</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>tetraedri</translation>
    </message>
    <message>
        <source>Err&amp;or</source>
        <translation>Err&amp;ore</translation>
    </message>
    <message>
        <source>± %1 in value
warping %2</source>
        <translation>± %1 nel valore
deformazione %2</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracySlider</name>
    <message>
        <source>Error in percent of the value range</source>
        <translation>Errore in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Error in percent of the value range: coarse on the left, every sample exact on the right</source>
        <translation>Errore in percento dell&apos;intervallo dei valori: grossolano a sinistra, ogni campione esatto a destra</translation>
    </message>
</context>
<context>
    <name>tetra::AnimationPanel</name>
    <message>
        <source>&amp;Save Film…</source>
        <translation>&amp;Salva filmato…</translation>
    </message>
    <message>
        <source>Kind of film</source>
        <translation>Tipo di filmato</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Giro completo</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Fotogrammi chiave</translation>
    </message>
    <message>
        <source>The camera goes round what is shown, or from view to view</source>
        <translation>La camera gira attorno a ciò che si vede, o va da vista a vista</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Fotogrammi al secondo</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> immagini/s</translation>
    </message>
    <message>
        <source>Pictures a second of the film</source>
        <translation>Immagini al secondo nel filmato</translation>
    </message>
    <message>
        <source>Write it as pictures or a video</source>
        <translation>Lo scrive come immagini o come video</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Tipo</translation>
    </message>
    <message>
        <source>Ra&amp;te</source>
        <translation>&amp;Cadenza</translation>
    </message>
    <message>
        <source>Axis to turn around</source>
        <translation>Asse di rotazione</translation>
    </message>
    <message>
        <source>Around the vertical axis</source>
        <translation>Attorno all&apos;asse verticale</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>In su e in giù</translation>
    </message>
    <message>
        <source>Up and down the camera comes back to where it began, and stops at the poles</source>
        <translation>In su e in giù la camera torna da dove è partita, e si ferma ai poli</translation>
    </message>
    <message>
        <source>Angle to turn by</source>
        <translation>Angolo di rotazione</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to turn by, in degrees; negative the other way round</source>
        <translation>Angolo di rotazione, in gradi; negativo nel verso opposto</translation>
    </message>
    <message>
        <source>Number of frames</source>
        <translation>Numero di fotogrammi</translation>
    </message>
    <message>
        <source>Pictures of the whole film</source>
        <translation>Immagini di tutto il filmato</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>A&amp;sse</translation>
    </message>
    <message>
        <source>An&amp;gle</source>
        <translation>An&amp;golo</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>&amp;Fotogrammi</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotogramma</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>Il fotogramma mostrato</translation>
    </message>
    <message>
        <source>Add two views or more.</source>
        <translation>Aggiungere due viste o più.</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 fotogrammi, %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ferma</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Riproduci</translation>
    </message>
</context>
<context>
    <name>tetra::AnnotationRows</name>
    <message>
        <source>Top left</source>
        <translation>In alto a sinistra</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>In alto a destra</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>In basso a sinistra</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>In basso a destra</translation>
    </message>
    <message>
        <source>Corner of the picture where it stands</source>
        <translation>Angolo dell&apos;immagine in cui si trova</translation>
    </message>
    <message>
        <source>%1: corner</source>
        <translation>%1: angolo</translation>
    </message>
</context>
<context>
    <name>tetra::BudgetBox</name>
    <message>
        <source>Most tetrahedra</source>
        <translation>Massimo di tetraedri</translation>
    </message>
    <message>
        <source>The mesh is as good as so many tetrahedra allow</source>
        <translation>La mesh è buona quanto lo permettono tanti tetraedri</translation>
    </message>
</context>
<context>
    <name>tetra::BuildPanel</name>
    <message>
        <source>Open a dataset to build a model of it.</source>
        <translation>Aprire un insieme di dati per costruirne il modello.</translation>
    </message>
    <message>
        <source>Builder</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>How the model is built</source>
        <translation>Come si costruisce il modello</translation>
    </message>
    <message>
        <source>B&amp;uilder</source>
        <translation>Met&amp;odo</translation>
    </message>
    <message>
        <source>Model file</source>
        <translation>File del modello</translation>
    </message>
    <message>
        <source>The file that the model is written to</source>
        <translation>Il file in cui si scrive il modello</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Sfoglia…</translation>
    </message>
    <message>
        <source>&amp;Model file</source>
        <translation>Fi&amp;le del modello</translation>
    </message>
    <message>
        <source>Progress of the build</source>
        <translation>Avanzamento della costruzione</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnulla</translation>
    </message>
    <message>
        <source>Stop the build and discard what it has made</source>
        <translation>Ferma la costruzione e scarta ciò che ha fatto</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>F&amp;erma e conserva</translation>
    </message>
    <message>
        <source>Stop the build and keep what is finished as the model, with the accuracy reached so far</source>
        <translation>Ferma la costruzione; ciò che è pronto diventa il modello, con l&apos;accuratezza raggiunta</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annullamento…</translation>
    </message>
    <message>
        <source>Keeping what is finished…</source>
        <translation>Si conserva ciò che è pronto…</translation>
    </message>
    <message>
        <source>&amp;Build and Replace</source>
        <translation>Costruisci e &amp;sostituisci</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Costruisci</translation>
    </message>
    <message>
        <source>This file exists; it is replaced when the build is done.</source>
        <translation>Questo file esiste; viene sostituito a costruzione finita.</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Avvio…</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, ancora %2</translation>
    </message>
    <message>
        <source>Model File</source>
        <translation>File del modello</translation>
    </message>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelli (*.tan)</translation>
    </message>
    <message>
        <source>%1 scattered points</source>
        <translation>%1 punti sparsi</translation>
    </message>
    <message>
        <source>irregular mesh of %1 points, %2 tetrahedra</source>
        <translation>mesh irregolare di %1 punti, %2 tetraedri</translation>
    </message>
    <message>
        <source>curvilinear grid of %1 points, %2 cells</source>
        <translation>griglia curvilinea di %1 punti, %2 celle</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 campioni</translation>
    </message>
    <message>
        <source>%1, %2, values %3 to %4</source>
        <translation>%1, %2, valori da %3 a %4</translation>
    </message>
    <message>
        <source>&amp;Import Options…</source>
        <translation>Opzioni di &amp;importazione…</translation>
    </message>
    <message>
        <source>Read the file again with other options: other values, a part of it, fewer points</source>
        <translation>Rilegge il file con altre opzioni: altri valori, una sua parte, meno punti</translation>
    </message>
    <message>
        <source>Estimated from a few thousand of the dataset&apos;s samples; it may be off by a factor of two</source>
        <translation>Stimato da qualche migliaio di campioni; può discostarsi di un fattore due</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Qui&amp;ck look, error 1 %</source>
        <translation>&amp;Rapido, errore 1 %</translation>
    </message>
    <message>
        <source>Keeps what is needed for an error of 1 % of the value range: enough for a first look</source>
        <translation>Conserva ciò che serve per un errore dell&apos;1 % dell&apos;intervallo dei valori: basta per un primo sguardo</translation>
    </message>
    <message>
        <source>&amp;Good, error 0.1 %</source>
        <translation>&amp;Buono, errore 0,1 %</translation>
    </message>
    <message>
        <source>Keeps what is needed for an error of 0.1 % of the value range: pictures can hardly be told from those of the full data</source>
        <translation>Conserva ciò che serve per un errore dello 0,1 % dell&apos;intervallo dei valori: le immagini si distinguono appena da quelle dei dati completi</translation>
    </message>
    <message>
        <source>&amp;Everything</source>
        <translation>&amp;Tutto</translation>
    </message>
    <message>
        <source>Keeps every value of the dataset, so that any accuracy can be shown later</source>
        <translation>Conserva ogni valore dell&apos;insieme di dati, così poi si può mostrare qualsiasi accuratezza</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Dettaglio</translation>
    </message>
    <message>
        <source>Detail (model size, build time)</source>
        <translation>Dettaglio (dimensione del modello, tempo di costruzione)</translation>
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
        <translation>Colore</translation>
    </message>
    <message>
        <source>Other Colour…</source>
        <translation>Altro colore…</translation>
    </message>
</context>
<context>
    <name>tetra::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Scrivere che cosa si vuole fare</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>A few letters of a command are enough. Enter does it, Esc leaves.</source>
        <translation>Bastano poche lettere di un comando. Invio lo esegue, Esc chiude.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandi</translation>
    </message>
</context>
<context>
    <name>tetra::EditMenu</name>
    <message>
        <source>&amp;More opaque</source>
        <translation>&amp;Più opaca</translation>
    </message>
    <message>
        <source>&amp;Less opaque</source>
        <translation>&amp;Meno opaca</translation>
    </message>
    <message>
        <source>Swap &amp;ends</source>
        <translation>Scambia gli &amp;estremi</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>Più &amp;larga</translation>
    </message>
    <message>
        <source>Na&amp;rrower</source>
        <translation>Più st&amp;retta</translation>
    </message>
    <message>
        <source>Spread over all &amp;values</source>
        <translation>Estendi a tutti i &amp;valori</translation>
    </message>
    <message>
        <source>Select &amp;all points</source>
        <translation>Seleziona &amp;tutti i punti</translation>
    </message>
    <message>
        <source>&amp;Copy points</source>
        <translation>&amp;Copia punti</translation>
    </message>
    <message>
        <source>&amp;Paste points</source>
        <translation>&amp;Incolla punti</translation>
    </message>
    <message>
        <source>D&amp;uplicate points</source>
        <translation>D&amp;uplica punti</translation>
    </message>
    <message>
        <source>&amp;Remove points</source>
        <translation>&amp;Elimina punti</translation>
    </message>
    <message>
        <source>&amp;Distribute values evenly</source>
        <translation>&amp;Distribuisci i valori uniformemente</translation>
    </message>
    <message>
        <source>&amp;Flip left to right</source>
        <translation>&amp;Capovolgi da sinistra a destra</translation>
    </message>
    <message>
        <source>&amp;Invert opacities</source>
        <translation>Inverti le o&amp;pacità</translation>
    </message>
    <message>
        <source>Ramp from first to last</source>
        <translation>Rampa dal primo all&apos;ultimo</translation>
    </message>
    <message>
        <source>&amp;Simplify: fewer points, same look</source>
        <translation>&amp;Semplifica: meno punti, stesso aspetto</translation>
    </message>
    <message>
        <source>Add a pea&amp;k</source>
        <translation>Aggiungi un picc&amp;o</translation>
    </message>
    <message>
        <source>Ali&amp;gn</source>
        <translation>Alli&amp;nea</translation>
    </message>
    <message>
        <source>Opacities to the &amp;first</source>
        <translation>Opacità come la &amp;prima</translation>
    </message>
    <message>
        <source>Opacities to the &amp;mean</source>
        <translation>Opacità alla &amp;media</translation>
    </message>
    <message>
        <source>Opacities to the &amp;least</source>
        <translation>Opacità alla mi&amp;nima</translation>
    </message>
    <message>
        <source>Opacities to the l&amp;argest</source>
        <translation>Opacità alla mas&amp;sima</translation>
    </message>
    <message>
        <source>&amp;Values of two neighbours: a step</source>
        <translation>&amp;Valori di due vicini: un gradino</translation>
    </message>
    <message>
        <source>Make a gr&amp;oup</source>
        <translation>Forma un &amp;gruppo</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Seleziona un gruppo</translation>
    </message>
    <message>
        <source>Group &amp;%1</source>
        <translation>Gruppo &amp;%1</translation>
    </message>
    <message>
        <source>&amp;No group</source>
        <translation>&amp;Nessun gruppo</translation>
    </message>
    <message>
        <source>When points meet neighbouri&amp;ng points</source>
        <translation>Se incontra altri pu&amp;nti</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Fermarsi</translation>
    </message>
    <message>
        <source>&amp;Push them along</source>
        <translation>&amp;Spingerli</translation>
    </message>
    <message>
        <source>Move p&amp;ast them</source>
        <translation>Su&amp;perarli</translation>
    </message>
    <message>
        <source>Mas&amp;k: show some values only</source>
        <translation>&amp;Maschera: mostra solo alcuni valori</translation>
    </message>
    <message>
        <source>Add an iso&amp;value</source>
        <translation>Aggiungi un iso&amp;valore</translation>
    </message>
    <message>
        <source>Add a &amp;point</source>
        <translation>Aggiungi un &amp;punto</translation>
    </message>
    <message>
        <source>Add an &amp;isovalue</source>
        <translation>Aggiungi un &amp;isovalore</translation>
    </message>
    <message>
        <source>Cl&amp;ear mark</source>
        <translation>&amp;Cancella segno</translation>
    </message>
    <message>
        <source>Follow the logarit&amp;hm of the value</source>
        <translation>Segui il &amp;logaritmo del valore</translation>
    </message>
    <message>
        <source>From &amp;the picked value</source>
        <translation>&amp;Dal valore scelto</translation>
    </message>
</context>
<context>
    <name>tetra::EmptyPage</name>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>File recenti</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Aprire un insieme di dati o un modello</translation>
    </message>
    <message>
        <source>Drop a file: a dataset (a volume, a grid, a mesh or points), a .tan model or a session. TAn shows large data at any accuracy, with a known error.</source>
        <translation>Trascinare un file: un insieme di dati (un volume, una griglia, una mesh o punti), un modello .tan o una sessione. TAn mostra dati grandi con qualsiasi accuratezza e con errore noto.</translation>
    </message>
    <message>
        <source>Open a dataset, a model or a session (Ctrl+O)</source>
        <translation>Apre un insieme di dati, un modello o una sessione (Ctrl+O)</translation>
    </message>
    <message>
        <source>Or try a sample</source>
        <translation>Oppure provare un esempio</translation>
    </message>
    <message>
        <source>Samples are computed when you choose one; nothing is downloaded.</source>
        <translation>Gli esempi si calcolano quando se ne sceglie uno; non si scarica nulla.</translation>
    </message>
</context>
<context>
    <name>tetra::FilmDialog</name>
    <message>
        <source>Numbered PNG pictures</source>
        <translation>Immagini PNG numerate</translation>
    </message>
    <message>
        <source>MP4 video (H.264)</source>
        <translation>Video MP4 (H.264)</translation>
    </message>
    <message>
        <source>WebM video (VP9)</source>
        <translation>Video WebM (VP9)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Sfoglia…</translation>
    </message>
    <message>
        <source>Save Film</source>
        <translation>Salva filmato</translation>
    </message>
    <message>
        <source>Videos can be made where the program ffmpeg is installed</source>
        <translation>I video si possono fare dove è installato il programma ffmpeg</translation>
    </message>
    <message>
        <source>Videos are made by %1</source>
        <translation>I video sono fatti da %1</translation>
    </message>
    <message>
        <source>The video, or the name that numbers are added to</source>
        <translation>Il video, o il nome a cui si aggiungono i numeri</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>Fil&amp;e</source>
        <translation>Fil&amp;e</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Filmato</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnulla</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>&amp;Chiudi</translation>
    </message>
    <message>
        <source>A film that is being written goes on</source>
        <translation>Un filmato che si sta scrivendo continua</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Salvato.</translation>
    </message>
    <message>
        <source>It has no frames yet: add two views or more in the panel Animation.</source>
        <translation>Non ha ancora fotogrammi: aggiungere due viste o più nel pannello Animazione.</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 fotogrammi, %2</translation>
    </message>
    <message>
        <source>%1; writing takes about %2</source>
        <translation>%1; la scrittura richiede circa %2</translation>
    </message>
    <message>
        <source>%1, …</source>
        <translation>%1, …</translation>
    </message>
    <message>
        <source>Files of this name are there already and will be replaced: %1.</source>
        <translation>Esistono già file con questo nome e verranno sostituiti: %1.</translation>
    </message>
    <message>
        <source>&amp;Replace and Save</source>
        <translation>Sostituisci e &amp;salva</translation>
    </message>
    <message>
        <source>Beginning…</source>
        <translation>Si comincia…</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotogramma %1 di %2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, restano circa %2</translation>
    </message>
</context>
<context>
    <name>tetra::FocusPanel</name>
    <message>
        <source>A part of the domain with an error of its own. Choose a shape, then drag its handles in the picture; a double click on a surface brings the focus there.</source>
        <translation>Una parte del dominio con un errore proprio. Scegliere una forma, poi trascinarne le maniglie nell&apos;immagine; un doppio clic su una superficie vi porta il focus.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
    <message>
        <source>The same error everywhere</source>
        <translation>Lo stesso errore ovunque</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Box</translation>
    </message>
    <message>
        <source>A box with an error of its own (B)</source>
        <translation>Un parallelepipedo con un errore proprio (B)</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sfera</translation>
    </message>
    <message>
        <source>A sphere with an error of its own (F)</source>
        <translation>Una sfera con un errore proprio (F)</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>&amp;Centro</translation>
    </message>
    <message>
        <source>Centre of the focus, in the coordinates of the data</source>
        <translation>Centro del focus, nelle coordinate dei dati</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Lati</translation>
    </message>
    <message>
        <source>Edges of the box, in data units</source>
        <translation>Lati del parallelepipedo, nelle unità dei dati</translation>
    </message>
    <message>
        <source>Radius of the sphere</source>
        <translation>Raggio della sfera</translation>
    </message>
    <message>
        <source>Radius of the sphere, in data units</source>
        <translation>Raggio della sfera, nelle unità dei dati</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Transizione</translation>
    </message>
    <message>
        <source>The distance over which the error grows from that in the focus to that outside, in data units; 0 is a sharp border</source>
        <translation>La distanza su cui l&apos;errore cresce da quello nel focus a quello esterno, nelle unità dei dati; 0 è un bordo netto</translation>
    </message>
    <message>
        <source>Error in the focus</source>
        <translation>Errore nel focus</translation>
    </message>
    <message>
        <source>Error in the focus, in percent of the value range</source>
        <translation>Errore nel focus, in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Move the focus to what the camera looks at (C)</source>
        <translation>Porta il focus dove guarda la camera (C)</translation>
    </message>
    <message>
        <source>Place, size, error and fall-off as they were at first</source>
        <translation>Posizione, dimensione, errore e transizione com&apos;erano all&apos;inizio</translation>
    </message>
    <message>
        <source>Outside %1, as chosen under Accuracy.</source>
        <translation>All&apos;esterno %1, come scelto in Accuratezza.</translation>
    </message>
    <message>
        <source>Between %1 and %2 tetrahedra.</source>
        <translation>Fra %1 e %2 tetraedri.</translation>
    </message>
    <message>
        <source>Rad&amp;ius</source>
        <translation>Ragg&amp;io</translation>
    </message>
    <message>
        <source>Error i&amp;nside</source>
        <translation>Errore i&amp;nterno</translation>
    </message>
    <message>
        <source>Fa&amp;ll-off</source>
        <translation>Trans&amp;izione</translation>
    </message>
    <message>
        <source>&amp;Move to Centre of View</source>
        <translation>Al &amp;centro della vista</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>With the budget the error outside is %1 times this one.</source>
        <translation>Con il limite l&apos;errore esterno è %1 volte questo.</translation>
    </message>
    <message>
        <source>A focus is not coarser than what is around it, so it gets the same error.</source>
        <translation>Un fuoco non è più grossolano di ciò che lo circonda, quindi riceve lo stesso errore.</translation>
    </message>
    <message>
        <source>A focus is not coarser than what is around it, so it gets %1.</source>
        <translation>Un fuoco non è più grossolano di ciò che lo circonda, quindi riceve %1.</translation>
    </message>
</context>
<context>
    <name>tetra::HistogramView</name>
    <message>
        <source>Histogram</source>
        <translation>Istogramma</translation>
    </message>
    <message>
        <source>How often the values of the mesh that is shown occur, on a logarithmic scale; from the least to the largest value, in the units of the data</source>
        <translation>Quanto spesso si presentano i valori della mesh mostrata, in scala logaritmica, dal valore minimo al massimo, nelle unità dei dati</translation>
    </message>
</context>
<context>
    <name>tetra::ImportDialog</name>
    <message>
        <source>&amp;Read</source>
        <translation>&amp;Leggi</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Reader</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Reader used for this file</source>
        <translation>Lettore usato per questo file</translation>
    </message>
    <message>
        <source>R&amp;eader</source>
        <translation>L&amp;ettura</translation>
    </message>
    <message>
        <source>Import options</source>
        <translation>Opzioni di importazione</translation>
    </message>
    <message>
        <source>Subset</source>
        <translation>Sottoinsieme</translation>
    </message>
    <message>
        <source>Layouts that fit</source>
        <translation>Formati adatti</translation>
    </message>
    <message>
        <source>Sizes and types that would fill the file exactly, the likeliest first</source>
        <translation>Dimensioni e tipi che riempirebbero esattamente il file, i più probabili per primi</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Avanzamento della lettura</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importa %1</translation>
    </message>
    <message>
        <source>%1, %2 bytes</source>
        <translation>%1, %2 byte</translation>
    </message>
    <message>
        <source>None is known</source>
        <translation>Nessuno noto</translation>
    </message>
    <message>
        <source>Give the number of points along x, y and z, as in 64x64x32.</source>
        <translation>Dare il numero di punti lungo x, y e z, come in 64x64x32.</translation>
    </message>
    <message>
        <source>Size check</source>
        <translation>Controllo della dimensione</translation>
    </message>
    <message>
        <source>&amp;Suggestion</source>
        <translation>&amp;Proposta</translation>
    </message>
    <message>
        <source>Open with these options</source>
        <translation>Apre con queste opzioni</translation>
    </message>
    <message>
        <source>Stops reading, or closes this window</source>
        <translation>Ferma la lettura, o chiude questa finestra</translation>
    </message>
    <message>
        <source>An upper bound; a model with less detail takes less.</source>
        <translation>Un limite superiore; un modello con meno dettaglio richiede meno.</translation>
    </message>
</context>
<context>
    <name>tetra::ImportRegion</name>
    <message>
        <source>&amp;All Points</source>
        <translation>Tutti i pu&amp;nti</translation>
    </message>
    <message>
        <source>Only a &amp;box in space</source>
        <translation>Solo un &amp;box nello spazio</translation>
    </message>
    <message>
        <source>Takes every point of the whole dataset</source>
        <translation>Prende ogni punto dell&apos;intero insieme di dati</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Primo</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Ultimo</translation>
    </message>
    <message>
        <source>Stride</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>First point along %1</source>
        <translation>Primo punto lungo %1</translation>
    </message>
    <message>
        <source>The first point that is taken, counted from 0</source>
        <translation>Il primo punto preso, contando da 0</translation>
    </message>
    <message>
        <source>Last point along %1</source>
        <translation>Ultimo punto lungo %1</translation>
    </message>
    <message>
        <source>The last point that is taken, counted from 0</source>
        <translation>L&apos;ultimo punto preso, contando da 0</translation>
    </message>
    <message>
        <source>Stride along %1</source>
        <translation>Passo lungo %1</translation>
    </message>
    <message>
        <source>Keep every n-th point</source>
        <translation>Mantiene un punto ogni n</translation>
    </message>
    <message>
        <source>Takes only what lies in a box; of irregular meshes whole tetrahedra</source>
        <translation>Prende solo ciò che sta in un parallelepipedo; di mesh irregolari tetraedri interi</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Da %1</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>A %1</translation>
    </message>
    <message>
        <source>A corner of the box, in the coordinates of the data</source>
        <translation>Un vertice del parallelepipedo, nelle coordinate dei dati</translation>
    </message>
</context>
<context>
    <name>tetra::IsovaluePanel</name>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>A&amp;ggiungi isovalore</translation>
    </message>
    <message>
        <source>No isovalue: there is nothing to draw but the outline.</source>
        <translation>Nessun isovalore: non c&apos;è nulla da disegnare tranne il contorno.</translation>
    </message>
    <message>
        <source>Add an isosurface at another value (Ctrl+I)</source>
        <translation>Aggiunge un&apos;isosuperficie a un altro valore (Ctrl+I)</translation>
    </message>
</context>
<context>
    <name>tetra::IsovalueRow</name>
    <message>
        <source>Isovalue</source>
        <translation>Isovalore</translation>
    </message>
    <message>
        <source>Isovalue, in the units of the data: %1 to %2</source>
        <translation>Isovalore, nelle unità dei dati: da %1 a %2</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacità</translation>
    </message>
    <message>
        <source>Opacity in percent; below 100 % what lies behind shows through</source>
        <translation>Opacità in percento; sotto il 100 % traspare ciò che sta dietro</translation>
    </message>
    <message>
        <source>Show this isosurface</source>
        <translation>Mostra questa isosuperficie</translation>
    </message>
    <message>
        <source>Remove this isovalue (Del)</source>
        <translation>Rimuove questo isovalore (Canc)</translation>
    </message>
    <message>
        <source>Remove this isovalue</source>
        <translation>Rimuove questo isovalore</translation>
    </message>
</context>
<context>
    <name>tetra::KeepSession</name>
    <message>
        <source>Save Session</source>
        <translation>Salva sessione</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sessioni (*.tansession)</translation>
    </message>
    <message>
        <source>TAn ended unexpectedly while %1 was open. How it was seen can be restored.</source>
        <translation>TAn è terminato inaspettatamente mentre %1 era aperto. Si può ripristinare come lo si vedeva.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Ripristina</translation>
    </message>
    <message>
        <source>%1 holds the view that it shows, which can be restored.</source>
        <translation>%1 contiene la vista che mostra; si può ripristinare.</translation>
    </message>
    <message>
        <source>Saved automatically on %1. Model: %2</source>
        <translation>Salvata automaticamente il %1. Modello: %2</translation>
    </message>
</context>
<context>
    <name>tetra::KeyFrameList</name>
    <message>
        <source>%1°, %2° at %3</source>
        <translation>%1°, %2° a %3</translation>
    </message>
    <message>
        <source>%1, %2 tetrahedra</source>
        <translation>%1, %2 tetraedri</translation>
    </message>
    <message>
        <source>%1, error %2</source>
        <translation>%1, errore %2</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Fotogrammi chiave</translation>
    </message>
    <message>
        <source>Enter shows a key frame, Delete removes it, Alt with an arrow moves it</source>
        <translation>Invio mostra un fotogramma chiave, Canc lo elimina, Alt con una freccia lo sposta</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tempo (s)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Azimuth and elevation, distance in the units of the data, accuracy</source>
        <translation>Azimut ed elevazione, distanza nelle unità dei dati, accuratezza</translation>
    </message>
    <message>
        <source>&amp;Add View</source>
        <translation>&amp;Aggiungi vista</translation>
    </message>
    <message>
        <source>Add what is seen now as the next key frame</source>
        <translation>Aggiunge ciò che si vede ora come prossimo fotogramma chiave</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Sostituisci</translation>
    </message>
    <message>
        <source>Put what is seen now in the place of this key frame</source>
        <translation>Mette ciò che si vede ora al posto di questo fotogramma chiave</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>Show this key frame (Enter)</source>
        <translation>Mostra questo fotogramma chiave (Invio)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Elimina</translation>
    </message>
    <message>
        <source>Remove this key frame (Delete)</source>
        <translation>Elimina questo fotogramma chiave (Canc)</translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation>&amp;Prima</translation>
    </message>
    <message>
        <source>Exchange it with the key frame before it (Alt+Up)</source>
        <translation>Lo scambia con il fotogramma chiave precedente (Alt+Su)</translation>
    </message>
    <message>
        <source>La&amp;ter</source>
        <translation>&amp;Dopo</translation>
    </message>
    <message>
        <source>Exchange it with the key frame after it (Alt+Down)</source>
        <translation>Lo scambia con il fotogramma chiave seguente (Alt+Giù)</translation>
    </message>
    <message>
        <source>Show Key Frame</source>
        <translation>Mostra fotogramma chiave</translation>
    </message>
</context>
<context>
    <name>tetra::Leaving</name>
    <message>
        <source>%1 % is done, about %2 are left.</source>
        <translation>Fatto il %1 %, mancano circa %2.</translation>
    </message>
    <message>
        <source>%1 % is done.</source>
        <translation>Fatto il %1 %.</translation>
    </message>
    <message>
        <source>It can continue in the background.</source>
        <translation>Può continuare in secondo piano.</translation>
    </message>
    <message>
        <source>If you stop now, you can keep what is finished as %1, a model of lower accuracy.</source>
        <translation>Fermandola ora si può conservare la parte finita come %1, un modello meno accurato.</translation>
    </message>
    <message>
        <source>Nothing of it can be kept yet.</source>
        <translation>Non si può ancora conservarne nulla.</translation>
    </message>
    <message>
        <source>Build in Progress</source>
        <translation>Costruzione in corso</translation>
    </message>
    <message>
        <source>The model of %1 is still being built.</source>
        <translation>Il modello di %1 è ancora in costruzione.</translation>
    </message>
    <message>
        <source>&amp;Continue Building</source>
        <translation>&amp;Continua a costruire</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>Ferma e co&amp;nserva</translation>
    </message>
    <message>
        <source>&amp;Discard Build</source>
        <translation>&amp;Scarta costruzione</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>If you stop it, nothing of it is kept.</source>
        <translation>Fermandolo non ne resta nulla.</translation>
    </message>
    <message>
        <source>Film in Progress</source>
        <translation>Filmato in corso</translation>
    </message>
    <message>
        <source>The film %1 is still being written.</source>
        <translation>Il filmato %1 è ancora in scrittura.</translation>
    </message>
    <message>
        <source>&amp;Continue Writing</source>
        <translation>&amp;Continua a scrivere</translation>
    </message>
    <message>
        <source>&amp;Discard Film</source>
        <translation>&amp;Scarta filmato</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Modifiche non salvate</translation>
    </message>
    <message>
        <source>The session %1 has unsaved changes.</source>
        <translation>La sessione %1 ha modifiche non salvate.</translation>
    </message>
    <message>
        <source>Your changes will be lost if you do not save them.</source>
        <translation>Le modifiche andranno perse se non vengono salvate.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>S&amp;carta</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Salvataggio</translation>
    </message>
    <message>
        <source>A file is still being saved.</source>
        <translation>È ancora in corso il salvataggio di un file.</translation>
    </message>
    <message>
        <source>TAn will quit when it is done.</source>
        <translation>TAn si chiuderà al termine.</translation>
    </message>
    <message>
        <source>&amp;Do Not Quit</source>
        <translation>&amp;Non uscire</translation>
    </message>
    <message>
        <source>&amp;Quit Without Saving</source>
        <translation>&amp;Esci senza salvare</translation>
    </message>
</context>
<context>
    <name>tetra::LostOffers</name>
    <message>
        <source>Sessions to restore</source>
        <translation>Sessioni da ripristinare</translation>
    </message>
    <message>
        <source>TAn ended unexpectedly while %1 was open.</source>
        <translation>TAn è terminato inaspettatamente mentre %1 era aperto.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Ripristina</translation>
    </message>
    <message>
        <source>Open the model with its view restored. The saved view is kept until that has worked.</source>
        <translation>Apre il modello con la vista ripristinata. La vista salvata resta finché l&apos;operazione non riesce.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>Ripristina %1</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Scarta</translation>
    </message>
    <message>
        <source>Discard the saved view (the model file is kept)</source>
        <translation>Scarta la vista salvata (il file del modello resta)</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>Scarta %1</translation>
    </message>
</context>
<context>
    <name>tetra::MainWindow</name>
    <message>
        <source>Picture</source>
        <translation>Immagine</translation>
    </message>
    <message>
        <source>One file can be open at a time; of those dropped, %1 was opened.</source>
        <translation>Si può aprire un solo file per volta; di quelli trascinati si è aperto %1.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Salvato %1</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>&amp;Svuota elenco</translation>
    </message>
    <message>
        <source>TAn</source>
        <translation>TAn</translation>
    </message>
    <message>
        <source>Dataset loaded. Choose options on the left and press Build to view it.</source>
        <translation>Insieme di dati caricato. Scegliere le opzioni a sinistra e premere «Costruisci» per vederlo.</translation>
    </message>
    <message>
        <source>About TAn</source>
        <translation>Informazioni su TAn</translation>
    </message>
    <message>
        <source>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: multiresolution volume data with a known error.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: dati di volume a multirisoluzione con errore noto.&lt;/p&gt;&lt;p&gt;Software libero sotto la GNU General Public License, versione 3 o successiva.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Salvataggio</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Si disegna l&apos;immagine</translation>
    </message>
    <message>
        <source>Drawing the film</source>
        <translation>Si disegna il filmato</translation>
    </message>
    <message>
        <source>Drawing the picture, %1 more waiting</source>
        <translation>Si disegna l&apos;immagine, altre %1 in attesa</translation>
    </message>
    <message>
        <source>Picture copied, %1 × %2 pixels</source>
        <translation>Immagine copiata, %1 × %2 pixel</translation>
    </message>
    <message>
        <source>Reset View</source>
        <translation>Reimposta la vista</translation>
    </message>
    <message>
        <source>The model %1 is built.</source>
        <translation>Il modello %1 è costruito.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Apri</translation>
    </message>
    <message>
        <source>%1[*] – TAn</source>
        <translation>%1[*] – TAn</translation>
    </message>
    <message>
        <source>Its model is being built. The panel on the left shows the progress.</source>
        <translation>Il suo modello è in costruzione. Il pannello a sinistra mostra l’avanzamento.</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Creazione dell&apos;esempio</translation>
    </message>
    <message>
        <source>%1 is not built yet. The picture still shows %2.</source>
        <translation>%1 non è ancora costruito. L&apos;immagine mostra ancora %2.</translation>
    </message>
    <message>
        <source>The picture is not of the present settings, which could not be shown.</source>
        <translation>L&apos;immagine non corrisponde alle impostazioni attuali, che non si sono potute mostrare.</translation>
    </message>
</context>
<context>
    <name>tetra::MessageBar</name>
    <message>
        <source>Show or hide the older messages</source>
        <translation>Mostra o nasconde i messaggi meno recenti</translation>
    </message>
    <message>
        <source>Close All</source>
        <translation>Chiudi tutti</translation>
    </message>
    <message>
        <source>Dismiss all messages</source>
        <translation>Chiude tutti i messaggi</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>Mostra meno</translation>
    </message>
    <message>
        <source>Show %1 more</source>
        <translation>Mostra altri %1</translation>
    </message>
</context>
<context>
    <name>tetra::MessageRow</name>
    <message>
        <source>Dismiss this message</source>
        <translation>Rimuovi questo messaggio</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 volte</translation>
    </message>
</context>
<context>
    <name>tetra::ModeActions</name>
    <message>
        <source>Show %1 (%2)</source>
        <translation>Mostra %1 (%2)</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
</context>
<context>
    <name>tetra::Opening</name>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelli (*.tan)</translation>
    </message>
    <message>
        <source>All that can be opened (%1)</source>
        <translation>Tutto ciò che si può aprire (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sessioni (*.tansession)</translation>
    </message>
    <message>
        <source>The model %1 is another one than when the session was saved: it was built anew, or replaced. It is shown as the session says, as far as that fits.</source>
        <translation>Il modello %1 non è lo stesso di quando la sessione fu salvata: è stato ricostruito o sostituito. Lo si mostra come dice la sessione, per quanto possibile.</translation>
    </message>
    <message>
        <source>Pictures with their sessions (*.png)</source>
        <translation>Immagini con le loro sessioni (*.png)</translation>
    </message>
</context>
<context>
    <name>tetra::OrientationActions</name>
    <message>
        <source>Turn Upside Down</source>
        <translation>Capovolgi</translation>
    </message>
    <message>
        <source>Let the axis that points up point down</source>
        <translation>Rivolge verso il basso l’asse che punta verso l’alto</translation>
    </message>
    <message>
        <source>Roll Clockwise</source>
        <translation>Ruota in senso orario</translation>
    </message>
    <message>
        <source>Turn the picture by 90° clockwise</source>
        <translation>Ruota l’immagine di 90° in senso orario</translation>
    </message>
    <message>
        <source>Roll Anticlockwise</source>
        <translation>Ruota in senso antiorario</translation>
    </message>
    <message>
        <source>Turn the picture by 90° anticlockwise</source>
        <translation>Ruota l’immagine di 90° in senso antiorario</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Raddrizza</translation>
    </message>
    <message>
        <source>Take the roll away: the axis that points up is upright</source>
        <translation>Annulla il rollio: l’asse che punta verso l’alto è verticale</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging turns the model freely, in any direction, instead of around the up axis</source>
        <translation>Trascinando, il modello ruota liberamente in ogni direzione anziché intorno all’asse verticale</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Show the model with this axis upright</source>
        <translation>Mostra il modello con questo asse in verticale</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>The picture is not rolled</source>
        <translation>L’immagine non è inclinata</translation>
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
        <translation>per esempio %1</translation>
    </message>
</context>
<context>
    <name>tetra::PickActions</name>
    <message>
        <source>&amp;Pick</source>
        <translation>&amp;Scegli</translation>
    </message>
    <message>
        <source>Pick the value at the pointer, or in the middle of the picture</source>
        <translation>Sceglie il valore sotto il puntatore, o al centro dell&apos;immagine</translation>
    </message>
    <message>
        <source>&amp;Isosurface at This Value</source>
        <translation>&amp;Isosuperficie a questo valore</translation>
    </message>
    <message>
        <source>Add an isosurface of the picked value</source>
        <translation>Aggiunge un&apos;isosuperficie del valore scelto</translation>
    </message>
    <message>
        <source>Add &amp;Transfer-Function Point</source>
        <translation>Aggiungi punto della funzione di &amp;trasferimento</translation>
    </message>
    <message>
        <source>Add a point to the transfer function at the picked value</source>
        <translation>Aggiunge un punto alla funzione di trasferimento al valore scelto</translation>
    </message>
    <message>
        <source>&amp;Clear Mark</source>
        <translation>&amp;Cancella segno</translation>
    </message>
    <message>
        <source>Clear the picked value</source>
        <translation>Cancella il valore scelto</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>Click a place in the picture first, or pick one</source>
        <translation>Fare prima clic su un punto dell&apos;immagine o sceglierne uno</translation>
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
        <translation>Indica nel &amp;file come è stata fatta</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Salva immagine</translation>
    </message>
    <message>
        <source>Program, model, accuracy, camera, transfer function and isovalues, so that the picture can be made again: opening it offers its view</source>
        <translation>Programma, modello, accuratezza, camera, funzione di trasferimento e isovalori, così che l&apos;immagine si possa rifare: aprendola viene offerta la sua vista</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Salva…</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copia</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>&amp;Chiudi</translation>
    </message>
    <message>
        <source>Put it on the clipboard</source>
        <translation>La mette negli appunti</translation>
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
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Larghezza in pixel</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Altezza in pixel</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Risoluzione</translation>
    </message>
    <message>
        <source>Print resolution in pixels per inch; the number of pixels does not change</source>
        <translation>Risoluzione di stampa in pixel per pollice; il numero di pixel non cambia</translation>
    </message>
    <message>
        <source>Trans&amp;parent background</source>
        <translation>Sfondo tras&amp;parente</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Come sullo schermo</translation>
    </message>
    <message>
        <source>Twice the screen size</source>
        <translation>Doppio dello schermo</translation>
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
        <translation>A scelta</translation>
    </message>
    <message>
        <source>Annotations and lines take as much of the picture as they do of the view</source>
        <translation>Annotazioni e linee occupano nell&apos;immagine quanto nella vista</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Grandezza</translation>
    </message>
    <message>
        <source>Pixe&amp;ls</source>
        <translation>Pi&amp;xel</translation>
    </message>
    <message>
        <source>Pri&amp;nt resolution</source>
        <translation>Ri&amp;soluzione di stampa</translation>
    </message>
    <message>
        <source>Only what is shown, to be laid over something else</source>
        <translation>Solo ciò che si vede, da sovrapporre ad altro</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Sfondo</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Annotazioni</translation>
    </message>
    <message>
        <source>%1 × %2 cm</source>
        <translation>%1 × %2 cm</translation>
    </message>
</context>
<context>
    <name>tetra::PluginWindow</name>
    <message>
        <source>Plugins</source>
        <translation>Plugin</translation>
    </message>
    <message>
        <source>Plugin</source>
        <translation>Plugin</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genere</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stato</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Looked for in: %1</source>
        <translation>Cercati in: %1</translation>
    </message>
    <message>
        <source>The plugin %1 cannot be used. %2</source>
        <translation>Il plugin %1 non può essere usato. %2</translation>
    </message>
    <message>
        <source>What was found, and why something is not used. Space switches a plugin on or off.</source>
        <translation>Che cosa si è trovato, e perché qualcosa non si usa. La barra spaziatrice attiva o disattiva un plugin.</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versione</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Changes take effect when TAn is restarted.</source>
        <translation>Le modifiche hanno effetto al prossimo avvio di TAn.</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>Co&amp;pia</translation>
    </message>
    <message>
        <source>Copy for a bug report</source>
        <translation>Copia per una segnalazione di errore</translation>
    </message>
</context>
<context>
    <name>tetra::PointNumbers</name>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Value of what is selected, in the units of the data; selected points move together</source>
        <translation>Valore di ciò che è selezionato, nelle unità dei dati; i punti selezionati si muovono insieme</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacità</translation>
    </message>
    <message>
        <source>Opacity of the selected points, in percent of the light that a unit distance takes away</source>
        <translation>Opacità dei punti selezionati, in percento della luce che la distanza unitaria assorbe</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Colour of what is selected</source>
        <translation>Colore di ciò che è selezionato</translation>
    </message>
    <message>
        <source>Unit distance</source>
        <translation>Distanza unitaria</translation>
    </message>
    <message>
        <source>The thickness, in the units of the data, that a layer must have for the opacities to hold: less makes everything denser</source>
        <translation>Lo spessore, nelle unità dei dati, che uno strato deve avere perché valgano le opacità: meno rende tutto più denso</translation>
    </message>
    <message>
        <source>Val&amp;ue</source>
        <translation>Val&amp;ore</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>O&amp;pacità</translation>
    </message>
    <message>
        <source>U&amp;nit distance</source>
        <translation>Dista&amp;nza unitaria</translation>
    </message>
</context>
<context>
    <name>tetra::PointTable</name>
    <message>
        <source>Points of the transfer function</source>
        <translation>Punti della funzione di trasferimento</translation>
    </message>
    <message>
        <source>Double click or F2 edits a cell; Del removes the selected points</source>
        <translation>Doppio clic o F2 modifica una cella; Canc elimina i punti selezionati</translation>
    </message>
</context>
<context>
    <name>tetra::PointTableModel</name>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Opacity, %</source>
        <translation>Opacità, %</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Colore</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppo</translation>
    </message>
    <message>
        <source>In the units of the data</source>
        <translation>Nelle unità dei dati</translation>
    </message>
    <message>
        <source>Fraction absorbed per unit distance</source>
        <translation>Frazione assorbita per distanza unitaria</translation>
    </message>
    <message>
        <source>As a name or as #rrggbb</source>
        <translation>Come nome o come #rrggbb</translation>
    </message>
    <message>
        <source>0 to 9, or empty</source>
        <translation>Da 0 a 9, o vuoto</translation>
    </message>
</context>
<context>
    <name>tetra::PresetPopup</name>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>&amp;Salva come preimpostazione…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Elimina</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Search for a preset</source>
        <translation>Cerca una preimpostazione</translation>
    </message>
    <message>
        <source>What to take of a preset</source>
        <translation>Che cosa prendere di una preimpostazione</translation>
    </message>
    <message>
        <source>Colours and opacities</source>
        <translation>Colori e opacità</translation>
    </message>
    <message>
        <source>Colours alone</source>
        <translation>Solo i colori</translation>
    </message>
    <message>
        <source>Opacities alone</source>
        <translation>Solo le opacità</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Keep the transfer function as it is now, for this and for other models</source>
        <translation>Conserva la funzione di trasferimento com&apos;è ora, per questo e per altri modelli</translation>
    </message>
    <message>
        <source>Delete the chosen preset, if it is one of your own</source>
        <translation>Elimina la preimpostazione scelta, se è una delle vostre</translation>
    </message>
    <message>
        <source>One of your own</source>
        <translation>Una delle vostre</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Salva come preset</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>Nome della preimpostazione:</translation>
    </message>
</context>
<context>
    <name>tetra::RegionActions</name>
    <message>
        <source>Focus: &amp;Sphere</source>
        <translation>Focus: &amp;sfera</translation>
    </message>
    <message>
        <source>More accurate in a sphere</source>
        <translation>Più accurato in una sfera</translation>
    </message>
    <message>
        <source>Focus: &amp;Box</source>
        <translation>Focus: &amp;box</translation>
    </message>
    <message>
        <source>More accurate in a box</source>
        <translation>Più accurato in un parallelepipedo</translation>
    </message>
    <message>
        <source>Focus to &amp;Centre of View</source>
        <translation>Focus al &amp;centro della vista</translation>
    </message>
    <message>
        <source>Move the focus to what the camera looks at</source>
        <translation>Porta il focus dove guarda la camera</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Finestra</translation>
    </message>
    <message>
        <source>Show the part of the domain in a box only</source>
        <translation>Mostra solo la parte del dominio in un parallelepipedo</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Switch on a focus first</source>
        <translation>Attivare prima un focus</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
</context>
<context>
    <name>tetra::RegionPanel</name>
    <message>
        <source>Only a &amp;window</source>
        <translation>Solo una fin&amp;estra</translation>
    </message>
    <message>
        <source>Show the part of the domain in a box only (W)</source>
        <translation>Mostra solo la parte del dominio in un parallelepipedo (W)</translation>
    </message>
    <message>
        <source>Where the window ends, in the coordinates of the data</source>
        <translation>Dove finisce la finestra, nelle coordinate dei dati</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;A</translation>
    </message>
    <message>
        <source>Cut exactly</source>
        <translation>Taglio esatto</translation>
    </message>
    <message>
        <source>Keep tetrahedra that touch it</source>
        <translation>Tetraedri che la toccano</translation>
    </message>
    <message>
        <source>Keep tetrahedra inside</source>
        <translation>Solo tetraedri all&apos;interno</translation>
    </message>
    <message>
        <source>Tetrahedra at the border</source>
        <translation>Tetraedri al bordo</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Bordo</translation>
    </message>
    <message>
        <source>Make the window as large as the domain</source>
        <translation>Rende la finestra grande quanto il dominio</translation>
    </message>
    <message>
        <source>In the units of the data: %1 to %2</source>
        <translation>Nelle unità dei dati: da %1 a %2</translation>
    </message>
    <message>
        <source>Smallest value</source>
        <translation>Valore minimo</translation>
    </message>
    <message>
        <source>Largest value</source>
        <translation>Valore massimo</translation>
    </message>
    <message>
        <source>&amp;Limit to a range of values</source>
        <translation>&amp;Limita a un intervallo di valori</translation>
    </message>
    <message>
        <source>Fro&amp;m</source>
        <translation>&amp;Da</translation>
    </message>
    <message>
        <source>&amp;Reset to Whole Domain</source>
        <translation>&amp;Ripristina tutto il dominio</translation>
    </message>
    <message>
        <source>&amp;Smallest</source>
        <translation>Mi&amp;nimo</translation>
    </message>
    <message>
        <source>&amp;Largest</source>
        <translation>Ma&amp;ssimo</translation>
    </message>
    <message>
        <source>Show only tetrahedra that can contain a value of a range. Isosurfaces of other values are not seen, or only in part.</source>
        <translation>Mostra solo i tetraedri che possono contenere un valore di un intervallo. Isosuperfici di altri valori non si vedono, o solo in parte.</translation>
    </message>
    <message>
        <source>How the window ends: tetrahedra at its border are cut exactly there, or kept or left out as a whole</source>
        <translation>Come finisce la finestra: i tetraedri al suo bordo si tagliano esattamente lì, o si tengono o tralasciano interi</translation>
    </message>
</context>
<context>
    <name>tetra::RenderingPanel</name>
    <message>
        <source>What is shown of the data</source>
        <translation>Che cosa si mostra dei dati</translation>
    </message>
    <message>
        <source>Rendering mode</source>
        <translation>Modalità di resa</translation>
    </message>
    <message>
        <source>Automatic (%1 frames/s)</source>
        <translation>Automatica (%1 immagini/s)</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> immagini/s</translation>
    </message>
    <message>
        <source>The frame rate to keep while something moves. If the machine is too slow, frames are drawn smaller and with fewer tetrahedra; the picture at rest is always complete.</source>
        <translation>La frequenza da mantenere mentre qualcosa si muove. Se il computer è troppo lento, i fotogrammi sono più piccoli e con meno tetraedri; l&apos;immagine ferma è sempre completa.</translation>
    </message>
    <message>
        <source>Frame rate while moving</source>
        <translation>Frequenza durante il movimento</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>M&amp;ostra</translation>
    </message>
    <message>
        <source>While movin&amp;g</source>
        <translation>In mo&amp;vimento</translation>
    </message>
</context>
<context>
    <name>tetra::SceneService</name>
    <message>
        <source>No renderer plugin could be loaded, so there is no way to show a model. %1</source>
        <translation>Nessun plugin di resa ha potuto essere caricato, perciò non c&apos;è modo di mostrare un modello. %1</translation>
    </message>
</context>
<context>
    <name>tetra::SlicePreview</name>
    <message>
        <source>Preview of a layer</source>
        <translation>Anteprima di uno strato</translation>
    </message>
    <message>
        <source>Axis of the layers</source>
        <translation>Asse degli strati</translation>
    </message>
    <message>
        <source>The axis across which the layer lies</source>
        <translation>L&apos;asse di traverso al quale giace lo strato</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>Di traverso a %1</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Strato</translation>
    </message>
    <message>
        <source>The layer that is shown, counted from 0</source>
        <translation>Lo strato mostrato, contando da 0</translation>
    </message>
    <message>
        <source>No preview: the layout is incomplete</source>
        <translation>Nessuna anteprima: il formato è incompleto</translation>
    </message>
    <message>
        <source>%1 to the right, %2 up; black %3, white %4</source>
        <translation>%1 verso destra, %2 in alto; nero %3, bianco %4</translation>
    </message>
</context>
<context>
    <name>tetra::StatisticsPanel</name>
    <message>
        <source>Mesh sizes</source>
        <translation>Dimensioni delle mesh</translation>
    </message>
    <message>
        <source>What the mesh of each error costs: its error in percent of the range of values and in their units, its size, the time to extract it, as measured here, and the memory that it occupies. Choose a line to see that mesh.</source>
        <translation>Quanto costa la mesh di ogni errore: l&apos;errore in percento dell&apos;intervallo dei valori e nelle loro unità, la dimensione, il tempo per estrarla, come misurato qui, e la memoria che occupa. Scegliere una riga per vedere quella mesh.</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>Co&amp;pia</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Salva…</translation>
    </message>
    <message>
        <source>Copy as text, with tabs between the columns</source>
        <translation>Copia come testo, con tabulazioni fra le colonne</translation>
    </message>
    <message>
        <source>Save the table as CSV or JSON (percent, decimal point)</source>
        <translation>Salva la tabella come CSV o JSON (percentuali, punto decimale)</translation>
    </message>
</context>
<context>
    <name>tetra::StatusLine</name>
    <message>
        <source>The picture at the chosen accuracy is being made</source>
        <translation>Si sta creando l&apos;immagine con l&apos;accuratezza scelta</translation>
    </message>
    <message>
        <source>Data points in the mesh that is shown</source>
        <translation>Punti dei dati nella mesh mostrata</translation>
    </message>
    <message>
        <source>Tetrahedra in the mesh that is shown</source>
        <translation>Tetraedri nella mesh mostrata</translation>
    </message>
    <message>
        <source>Triangles of all surfaces that are shown</source>
        <translation>Triangoli di tutte le superfici mostrate</translation>
    </message>
    <message>
        <source>Time for taking the mesh out of the model</source>
        <translation>Tempo per estrarre la mesh dal modello</translation>
    </message>
    <message>
        <source>Memory that the program occupies, mapped files included</source>
        <translation>Memoria occupata dal programma, compresi i file mappati</translation>
    </message>
    <message>
        <source>What draws the picture: OpenGL or the processor</source>
        <translation>Che cosa disegna l&apos;immagine: OpenGL o il processore</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 vertici</translation>
    </message>
    <message>
        <source>%1 tetrahedra</source>
        <translation>%1 tetraedri</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 triangoli</translation>
    </message>
    <message>
        <source>extracted in %1</source>
        <translation>estratta in %1</translation>
    </message>
    <message>
        <source>%1 per frame</source>
        <translation>%1 per fotogramma</translation>
    </message>
    <message>
        <source>Time for drawing the last picture; while it moves the frames a second, and how much smaller and of how many tetrahedra they are</source>
        <translation>Tempo per disegnare l&apos;ultima immagine; in movimento le immagini al secondo, e quanto sono più piccole e di quanti tetraedri</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 immagini/s</translation>
    </message>
    <message>
        <source>size 1/%1</source>
        <translation>dimensione 1/%1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Value and place that were picked in the picture, in the units of the data. Click elsewhere to pick another one, Esc takes the mark away.</source>
        <translation>Valore e posizione scelti nell&apos;immagine, nelle unità dei dati. Un clic altrove ne sceglie un altro, Esc toglie il segno.</translation>
    </message>
</context>
<context>
    <name>tetra::TaskLine</name>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
</context>
<context>
    <name>tetra::TransferCanvas</name>
    <message>
        <source>Transfer function</source>
        <translation>Funzione di trasferimento</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>Point %1 of %2: value %3, opacity %4</source>
        <translation>Punto %1 di %2: valore %3, opacità %4</translation>
    </message>
    <message>
        <source>Opacity against value. Drag points, click the curve or double click to add one, Delete removes; arrow keys move (finer with Ctrl, farther with Shift), Tab goes to the next. A frame or Ctrl+click selects several. The wheel zooms the values, with Ctrl the opacities; Home shows all. Ctrl+digit makes a group, the digit selects it. Behind: how often the values occur in the mesh.</source>
        <translation>L&apos;opacità secondo il valore. Trascinare i punti, fare clic sulla curva o doppio clic per aggiungerne uno, Canc elimina; le frecce spostano (più fine con Ctrl, più lontano con Maiusc), Tab va al prossimo. Un riquadro o Ctrl+clic ne seleziona più d&apos;uno. La rotella ingrandisce i valori, con Ctrl le opacità; Inizio mostra tutto. Ctrl+cifra forma un gruppo, la cifra lo seleziona. Sullo sfondo: quanto sono frequenti i valori nella mesh.</translation>
    </message>
    <message>
        <source>%1 points are selected</source>
        <translation>%1 punti selezionati</translation>
    </message>
    <message>
        <source>Value %1, opacity %2</source>
        <translation>Valore %1, opacità %2</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>gruppo %1</translation>
    </message>
    <message>
        <source>Isovalue %1 of %2: %3</source>
        <translation>Isovalore %1 di %2: %3</translation>
    </message>
    <message>
        <source>Lower end of the mask: %1</source>
        <translation>Estremo inferiore della maschera: %1</translation>
    </message>
    <message>
        <source>Upper end of the mask: %1</source>
        <translation>Estremo superiore della maschera: %1</translation>
    </message>
</context>
<context>
    <name>tetra::TransferPanel</name>
    <message>
        <source>S&amp;tep</source>
        <translation>&amp;Gradino</translation>
    </message>
    <message>
        <source>Lo&amp;garithmic</source>
        <translation>Lo&amp;garitmico</translation>
    </message>
    <message>
        <source>Give the point two sides: what lies below its value ends there, and what lies above begins</source>
        <translation>Dà al punto due lati: ciò che sta sotto il suo valore finisce lì, e ciò che sta sopra vi comincia</translation>
    </message>
    <message>
        <source>Show how often values occur on a logarithmic scale, so that rare ones are seen</source>
        <translation>Mostra in scala logaritmica quanto spesso si presentano i valori, così che si vedano quelli rari</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Transfer-function presets</source>
        <translation>Preset di funzioni di trasferimento</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambia</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Carica…</translation>
    </message>
    <message>
        <source>Take a transfer function from a file: one of TAn or presets of ParaView (JSON or XML)</source>
        <translation>Prende una funzione di trasferimento da un file: una di TAn o preimpostazioni di ParaView (JSON o XML)</translation>
    </message>
    <message>
        <source>The file holds several presets:</source>
        <translation>Il file contiene più preimpostazioni:</translation>
    </message>
    <message>
        <source>Save for &amp;ParaView…</source>
        <translation>Salva per &amp;ParaView…</translation>
    </message>
    <message>
        <source>Save Transfer Function for ParaView</source>
        <translation>Salva funzione di trasferimento per ParaView</translation>
    </message>
    <message>
        <source>ParaView presets (*.json)</source>
        <translation>Preimpostazioni di ParaView (*.json)</translation>
    </message>
    <message>
        <source>Transfer functions (*.json *.xml)</source>
        <translation>Funzioni di trasferimento (*.json *.xml)</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Save the transfer function as a JSON file, which “tan render” takes, too</source>
        <translation>Salva la funzione di trasferimento come file JSON, accettato anche da “tan render”</translation>
    </message>
    <message>
        <source>Load Transfer Function</source>
        <translation>Carica funzione di trasferimento</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Funzioni di trasferimento (*.json)</translation>
    </message>
    <message>
        <source>Save Transfer Function</source>
        <translation>Salva funzione di trasferimento</translation>
    </message>
    <message>
        <source>Axis of opacities</source>
        <translation>Asse delle opacità</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Lineare</translation>
    </message>
    <message>
        <source>S&amp;quare root</source>
        <translation>Radice &amp;quadrata</translation>
    </message>
    <message>
        <source>L&amp;ogarithmic: fine near zero</source>
        <translation>L&amp;ogaritmico: fine vicino allo zero</translation>
    </message>
    <message>
        <source>Zoom to the &amp;selected points</source>
        <translation>Ingrandisci i punti &amp;selezionati</translation>
    </message>
    <message>
        <source>Zoom to the &amp;values of the data</source>
        <translation>Ingrandisci i &amp;valori dei dati</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostra &amp;tutto</translation>
    </message>
    <message>
        <source>Value, opacity, colour and how often it occurs, at the pointer</source>
        <translation>Valore, opacità, colore e frequenza, al puntatore</translation>
    </message>
    <message>
        <source>Add a point after the selected one, or click on the curve, or double click in the plot</source>
        <translation>Aggiunge un punto dopo quello selezionato; oppure fare clic sulla curva, o doppio clic nel grafico</translation>
    </message>
    <message>
        <source>Remove what is selected (Del)</source>
        <translation>Elimina ciò che è selezionato (Canc)</translation>
    </message>
    <message>
        <source>Change the selected points, or all</source>
        <translation>Modifica i punti selezionati, o tutti</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>How the plot is shown</source>
        <translation>Come si mostra il grafico</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maschera</translation>
    </message>
    <message>
        <source>Show some values only: between two lines that can be dragged</source>
        <translation>Mostra solo alcuni valori: tra due linee che si possono trascinare</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabella</translation>
    </message>
    <message>
        <source>Show all points in a table to be edited</source>
        <translation>Mostra tutti i punti in una tabella modificabile</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Aggiungi un punto</translation>
    </message>
    <message>
        <source>Remove what is selected</source>
        <translation>Elimina ciò che è selezionato</translation>
    </message>
    <message>
        <source>Read-out</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Axis of values</source>
        <translation>Asse dei valori</translation>
    </message>
    <message>
        <source>Li&amp;near</source>
        <translation>Li&amp;neare</translation>
    </message>
    <message>
        <source>Logarithmic: by &amp;factors</source>
        <translation>Logaritmico: per &amp;fattori</translation>
    </message>
    <message>
        <source>The axis of values stays linear: a logarithmic one has no place for zero and less, and the data or the points begin at %1. Move the points above zero, or choose data of positive values.</source>
        <translation>L&apos;asse dei valori resta lineare: uno logaritmico non ha posto per lo zero e i valori inferiori, e i dati o i punti cominciano da %1. Spostare i punti sopra lo zero o scegliere dati con valori positivi.</translation>
    </message>
</context>
<context>
    <name>tetra::ValuePick</name>
    <message>
        <source>%1 at (%2, %3, %4)</source>
        <translation>%1 in (%2, %3, %4)</translation>
    </message>
</context>
<context>
    <name>tetra::ViewPanel</name>
    <message>
        <source>&amp;Load…</source>
        <translation>&amp;Carica…</translation>
    </message>
    <message>
        <source>Sa&amp;ve…</source>
        <translation>&amp;Salva…</translation>
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
        <translation>Elevazione</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>From the camera to the target, in data units</source>
        <translation>Dalla camera al bersaglio, nelle unità dei dati</translation>
    </message>
    <message>
        <source>View angle</source>
        <translation>Angolo di vista</translation>
    </message>
    <message>
        <source>View angle along the shorter side of the picture, in degrees</source>
        <translation>Angolo di vista lungo il lato più corto dell&apos;immagine, in gradi</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Prospettica</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallela</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Proiezione</translation>
    </message>
    <message>
        <source>Whether what is farther away looks smaller (Ctrl+P)</source>
        <translation>Se ciò che è più lontano appare più piccolo (Ctrl+P)</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Bersaglio</translation>
    </message>
    <message>
        <source>The point that is looked at, in the units of the data</source>
        <translation>Il punto che si guarda, nelle unità dei dati</translation>
    </message>
    <message>
        <source>A&amp;zimuth</source>
        <translation>A&amp;zimut</translation>
    </message>
    <message>
        <source>E&amp;levation</source>
        <translation>E&amp;levazione</translation>
    </message>
    <message>
        <source>D&amp;istance</source>
        <translation>D&amp;istanza</translation>
    </message>
    <message>
        <source>View &amp;angle</source>
        <translation>An&amp;golo di vista</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>&amp;Proiezione</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Guarda da questo lato</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Adatta</translation>
    </message>
    <message>
        <source>Show the whole domain (Home)</source>
        <translation>Mostra l&apos;intero dominio (Home)</translation>
    </message>
    <message>
        <source>Colour behind what is shown, also in saved pictures</source>
        <translation>Colore dietro a ciò che si mostra, anche nelle immagini salvate</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Colore di sfondo</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Predefinito</translation>
    </message>
    <message>
        <source>The colour that fits the window, light or dark</source>
        <translation>Il colore adatto alla finestra, chiaro o scuro</translation>
    </message>
    <message>
        <source>Take the camera from a JSON file</source>
        <translation>Prende la camera da un file JSON</translation>
    </message>
    <message>
        <source>Save the camera as a JSON file, which “tan render --camera” takes, too</source>
        <translation>Salva la camera come file JSON, accettato anche da “tan render --camera”</translation>
    </message>
    <message>
        <source>Bac&amp;kground</source>
        <translation>Sfon&amp;do</translation>
    </message>
    <message>
        <source>Load Camera</source>
        <translation>Carica camera</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>Camere (*.json)</translation>
    </message>
    <message>
        <source>Save Camera</source>
        <translation>Salva camera</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retro</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Basso</translation>
    </message>
    <message>
        <source>Direction around the up axis, in degrees</source>
        <translation>Direzione intorno all’asse verticale, in gradi</translation>
    </message>
    <message>
        <source>Height above the plane across the up axis, in degrees</source>
        <translation>Altezza sul piano perpendicolare all’asse verticale, in gradi</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollio</translation>
    </message>
    <message>
        <source>By how much the picture is turned clockwise, in degrees</source>
        <translation>Di quanto l’immagine è ruotata in senso orario, in gradi</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Asse in alto</translation>
    </message>
    <message>
        <source>Which axis of the data points up</source>
        <translation>Quale asse dei dati punta verso l’alto</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Piatto girevole</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Trascinamento</translation>
    </message>
    <message>
        <source>Whether dragging turns the model around the up axis, or freely in any direction (Ctrl+T)</source>
        <translation>Se trascinando il modello ruota intorno all’asse verticale o liberamente in ogni direzione (Ctrl+T)</translation>
    </message>
    <message>
        <source>&amp;Roll</source>
        <translation>&amp;Rollio</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>&amp;Alto</translation>
    </message>
    <message>
        <source>Dra&amp;gging</source>
        <translation>&amp;Trascina</translation>
    </message>
</context>
<context>
    <name>tetra::Viewport</name>
    <message>
        <source>OpenGL cannot be used, the picture is drawn by the processor instead. %1</source>
        <translation>OpenGL non si può usare, l&apos;immagine è disegnata dal processore. %1</translation>
    </message>
</context>
</TS>
