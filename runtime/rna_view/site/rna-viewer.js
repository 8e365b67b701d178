(()=>{var wn=class extends Error{constructor(e,t,n){super(`${t?t+": ":""}${n.slice(0,400)} [${e}]`),this.code=e,this.where=t}};function b(r,e,t){throw new wn(r,e,t)}var $=class extends Error{};var ds=65536,Yi=16384,jc=2**30,bn=class extends ${},Wt=class r{constructor(e,t){this.blob=e,this.name=t,this.size=e.size}expect(){}async read(e,t){return new Uint8Array(await this.blob.slice(e,t).arrayBuffer())}async part(e,t){return new r(this.blob.slice(e,t),this.name)}},tr=class r{static pauses=[300,1e3,3e3];static async open(e,t=()=>{},n,s=Nt(e)){let i=new r;Object.assign(i,{url:e,progress:t,signal:n,name:s,fetched:0,begun:0,expected:null,from:0});let a=await i._askHead(),o=/\/(\d+)$/.exec(a.headers.get("Content-Range")??"");i.ranged=a.status===206&&o!==null,a.status===206&&!i.ranged&&(await a.body?.cancel(),a=await i._ask({}));let l=Number(a.headers.get("Content-Length"))||0;i.ranged||(i.expected=l);let u=i.ranged?ds:jc;return l>u&&await i._tooLong(a,u),i.head=await i._transfer(a,0,u),i.size=i.ranged?Number(o[1]):i.head.length,i}async read(e,t){if(!this.ranged||t<=this.head.length)return this.head.subarray(e,Math.min(t,this.size));let n=Math.max(0,this.size-Yi);return e<n?this._range(e,t):(this.tail??=this._range(n,this.size),(await this.tail).subarray(e-n,t-n))}async part(e,t){let n=t-e,s=Object.assign(new r,this,{from:this.from+e,size:n,tail:void 0}),i=this.head.subarray(e,t);return s.head=i.length?i:await s._range(0,Math.min(ds,n)),s}expect(e){if(!this.ranged)return;let t=([s,i])=>i<=this.head.length||s>=this.size-Yi,n=e.filter(s=>!t(s)).reduce((s,[i,a])=>s+a-i,0);Object.assign(this,{begun:this.fetched,expected:n})}async _range(e,t){let n=await this._transfer(null,this.from+e,t-e);if(n.length<t-e)throw new $(`${this.name}: the server sent ${n.length} bytes of ${t-e}`);return n}async _askHead(){try{return await this._ask({Range:`bytes=0-${ds-1}`})}catch(e){if(!(e instanceof bn))throw e;return this._ask({})}}async _ask(e){let t;try{t=await fetch(this.url,{headers:e,signal:this.signal})}catch(n){if(n.name==="AbortError")throw n;let{protocol:s,origin:i}=new URL(this.url,location.href),a=new URL(location.href).origin;if(s==="file:")throw new $("a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the file here");let o=i===a?"":`, or its server does not allow ${a} (CORS)`;throw new bn(`cannot load ${this.url}: no answer${o}`)}if(!t.ok&&t.status!==416)throw new $(`cannot load ${this.url}: HTTP ${t.status}`);return t}async _transfer(e,t,n){let s=[],i=0;for(let a=0;;a++){let o=null;try{if(e??=await this._ask({Range:`bytes=${t+i}-${this.ranged?t+n-1:""}`}),this.ranged&&e.status!==206)throw new $(`${this.name}: the server forgot about ranges`);e.status===200&&(this.fetched-=i,i=s.length=0);for await(let u of Vc(e))i+=u.length,i>n&&await this._tooLong(e,n),s.push(u),this.fetched+=u.length,this.progress(this.fetched-this.begun,this.expected)}catch(u){if(u instanceof $&&!(u instanceof bn))throw u;this.signal?.throwIfAborted(),o=u}if(!o&&(i===n||t===0)||a===r.pauses.length){if(o)throw new $(`${this.name}: the connection was cut after ${i} bytes, ${a+1} times`);return Wc(s,i)}await new Promise(u=>setTimeout(u,r.pauses[a])),e=null}}async _tooLong(e,t){throw await(e.body??e).cancel().catch(()=>{}),new $(this.ranged?`${this.name}: the server sent more than the ${t} bytes that were asked for`:`${this.name}: more than ${t} bytes from a server without range requests: use rna-view, or a server that has them`)}};async function*Vc(r){if(r.status===416||!r.body)return;let e=r.body.getReader();try{for(let t=await e.read();!t.done;t=await e.read())yield t.value}finally{await e.cancel().catch(()=>{})}}function Wc(r,e){let t=new Uint8Array(e),n=0;for(let s of r)t.set(s,n),n+=s.length;return t}function Nt(r){let e=new URL(r,location.href).pathname.split("/").pop();try{return decodeURIComponent(e)||r}catch{return e}}var nr=class{constructor(e){Object.assign(this,{place:e,lines:new Map})}say(e,t=!1,n="page"){e?this.lines.set(n,{text:e,calm:t}):this.lines.delete(n),this.show()}show(){let e=[...this.lines.values()];this.put(new Set(e.map(({text:t})=>t)),e.every(({calm:t})=>t))}get whole(){return[...this.lines.values()].map(({text:e})=>e).join(`
`)||null}put(e,t){let n=[...e].map(s=>Object.assign(document.createElement("span"),{textContent:s}));this.place.hidden=!n.length,this.place.replaceChildren(...n),this.place.classList.toggle("calm",t)}},We=(r,e,t)=>Math.min(Math.max(r,e),t),rr=r=>((r+180)%360+360)%360-180;function It(r){return r<1e6?`${Math.round(r/1e3)} kB`:`${(r/1e6).toFixed(r<1e7?2:1)} MB`}var Ki=(r,e)=>e.find(t=>Zc(r.toLowerCase(),t)<=(t.length>3?2:1));function Zc(r,e){let t=[Array.from({length:e.length+1},(n,s)=>s)];for(let n=1;n<=r.length;n++){t.push([n]);for(let s=1;s<=e.length;s++){let i=n>1&&s>1&&r[n-1]===e[s-2]&&r[n-2]===e[s-1]?t[n-2][s-2]+1:1/0,a=t[n-1][s-1]+ +(r[n-1]!==e[s-1]);t[n].push(Math.min(t[n-1][s]+1,t[n][s-1]+1,a,i))}}return t[r.length][e.length]}function sr(r){if(/currentcolor/i.test(r))return null;let e=new OffscreenCanvas(1,1).getContext("2d");e.fillStyle="transparent",e.fillStyle=r,e.fillRect(0,0,1,1);let[t,n,s,i]=[...e.getImageData(0,0,1,1).data].map(a=>a/255);return i<1?null:[t,n,s].map(a=>a<=.04045?a/12.92:((a+.055)/1.055)**2.4)}var de=(r,e,t=1)=>r.map((n,s)=>n+t*e[s]),Ee=(r,e)=>r.map((t,n)=>t-e[n]),st=(r,e)=>r.map(t=>t*e),X=(r,e)=>r[0]*e[0]+r[1]*e[1]+r[2]*e[2],Tt=([r,e,t],[n,s,i])=>[e*i-t*s,t*n-r*i,r*s-e*n],Ot=r=>st(r,1/(Math.hypot(...r)||1));var Xi={azimuth:.6,elevation:.35,fov:30},ir=89*Math.PI/180,Yc=.95,Kc=Array.from({length:16},(r,e)=>e*Math.PI/8),ar={azimuth:null,elevation:null,distance:null,share:null},Xc={low:ar,high:ar,lowFov:null,highFov:null},Ji=r=>We(r,-ir,ir),gs=({minCameraOrbit:r,maxCameraOrbit:e,minFieldOfView:t,maxFieldOfView:n})=>({low:r??ar,high:e??ar,lowFov:t,highFov:n});function Qi(r,e,t){let n=de(r,e,-1),s=Math.hypot(...n);return{azimuth:Math.atan2(n[0],n[2]),elevation:Math.asin(n[1]/s),distance:s,target:e,fov:t}}var or=class{constructor(){Object.assign(this,{target:[0,0,0],distance:1,framed:1,size:1,turntable:0,...Xi}),this.limits=Xc}place(e,t,n){let s=e.map(g=>Object.fromEntries(Object.entries(g).filter(([,_])=>_!=null))),{azimuth:i,elevation:a,fov:o,target:l=[],distance:u,share:f=1}=Object.assign({},Xi,...s),{lowFov:p,highFov:m}=this.limits;Object.assign(this,{azimuth:i,elevation:a,fov:We(o,p??0,m??1/0)}),t&&this.frame(t,n),this.framed=this.distance,this.distance=u??f*this.framed,this.target=this.target.map((g,_)=>l[_]??g),this.limit()}limit(){let{low:e,high:t,lowFov:n,highFov:s}=this.limits,i=({distance:a,share:o})=>a??(o===null?null:o*this.framed);this.azimuth=We(this.azimuth,e.azimuth??-1/0,t.azimuth??1/0),this.elevation=We(this.elevation,t.elevation??-ir,e.elevation??ir),this.distance=We(this.distance,i(e)??.001*this.size,i(t)??1e4*this.size),this.fov=We(this.fov,n??0,s??1/0)}frame({min:e,max:t},n){this.target=st(de(e,t),.5),this.size=Math.hypot(...de(t,e,-1))/2||1;let s=Yc*Math.tan(this.fov*Math.PI/360),i=Array.from({length:8},(o,l)=>de([0,1,2].map(u=>(l>>u&1?t:e)[u]),this.target,-1)),a=Kc.flatMap(o=>{let{forward:l,side:u,above:f}=this._axes(o);return i.map(p=>Math.max(Math.abs(X(p,f)),Math.abs(X(p,u))/n)/s-X(p,l))});this.distance=Math.max(...a)||this.size}get position(){return de(this.target,this._away(this.turntable),this.distance)}turn(e,t){this.azimuth+=e,this.elevation+=t,this.limit()}zoom(e){this.distance*=e,this.limit()}pan(e,t){let{side:n,above:s}=this._axes(),i=2*this.distance*Math.tan(this.fov*Math.PI/360);this.target=de(de(this.target,n,e*i),s,t*i)}camera(e,t){let{forward:n,side:s,above:i}=this._axes(),a=Math.tan(this.fov*Math.PI/360),o=a*e/t;return{position:this.position,corner:de(de(n,s,-o),i,a),stepX:st(s,2*o/e),stepY:st(i,-2*a/t)}}_away(e){let t=Math.cos(this.elevation),n=this.azimuth+e;return[t*Math.sin(n),Math.sin(this.elevation),t*Math.cos(n)]}_axes(e=this.turntable){let t=st(this._away(e),-1),n=Ot(Tt(t,[0,1,0]));return{forward:t,side:n,above:Tt(n,t)}}};var lr=["prompt","loading","asset","shown","unavailable","failed","front","front-right","right","back-right","back","back-left","left","front-left","above","below","keys"],_s={en:["Drag to turn","Loading","A relightable asset","{name} is shown","The interactive view is not available here.","This could not be loaded.","View from the front","View from the front right","View from the right","View from the back right","View from the back","View from the back left","View from the left","View from the front left",", from above",", from below","Arrow keys or one finger orbit. Plus, minus or a pinch go nearer and farther. W, A, S, D or two fingers pan. Square brackets, Shift and arrow keys, three fingers or two that twist turn the light. Home resets."],de:["Zum Drehen ziehen","Wird geladen","Ein 3D-Objekt","{name} wird angezeigt","Die interaktive Ansicht ist hier nicht verf\xFCgbar.","Der Inhalt konnte nicht geladen werden.","Ansicht von vorn","Ansicht von vorn rechts","Ansicht von rechts","Ansicht von hinten rechts","Ansicht von hinten","Ansicht von hinten links","Ansicht von links","Ansicht von vorn links",", von oben",", von unten","Pfeiltasten oder ein Finger drehen. Plus, Minus oder zwei Finger, die sich spreizen, zoomen. W, A, S, D oder zwei Finger verschieben. Eckige Klammern, Umschalt und Pfeiltasten, drei Finger oder zwei, die sich drehen, drehen das Licht. Pos1 setzt zur\xFCck."],es:["Arrastra para girar","Cargando","Un objeto 3D","Se muestra {name}","La vista interactiva no est\xE1 disponible aqu\xED.","No se pudo cargar el contenido.","Vista frontal","Vista frontal derecha","Vista desde la derecha","Vista trasera derecha","Vista trasera","Vista trasera izquierda","Vista desde la izquierda","Vista frontal izquierda",", desde arriba",", desde abajo","Las flechas o un dedo giran la vista. M\xE1s, menos o pellizcar acercan y alejan. W, A, S, D o dos dedos desplazan. Los corchetes, May\xFAs y las flechas, tres dedos o dos que rotan giran la luz. Inicio restablece la vista."],fr:["Faites glisser pour tourner","Chargement","Un objet 3D","{name} est affich\xE9","La vue interactive n\u2019est pas disponible ici.","Le contenu n\u2019a pas pu \xEAtre charg\xE9.","Vue de face","Vue de face, \xE0 droite","Vue de droite","Vue arri\xE8re droite","Vue arri\xE8re","Vue arri\xE8re gauche","Vue de gauche","Vue de face, \xE0 gauche",", d\u2019en haut",", d\u2019en bas","Les fl\xE8ches ou un doigt tournent la vue. Plus, moins ou un pincement rapprochent et \xE9loignent. W, A, S, D ou deux doigts d\xE9placent. Les crochets, Maj et les fl\xE8ches, trois doigts ou deux qui pivotent tournent la lumi\xE8re. D\xE9but r\xE9initialise."],it:["Trascina per ruotare","Caricamento","Un oggetto 3D","{name} \xE8 visualizzato","La vista interattiva non \xE8 disponibile qui.","Impossibile caricare il contenuto.","Vista frontale","Vista frontale destra","Vista da destra","Vista posteriore destra","Vista posteriore","Vista posteriore sinistra","Vista da sinistra","Vista frontale sinistra",", dall\u2019alto",", dal basso","Le frecce o un dito ruotano la vista. Pi\xF9, meno o un pizzico avvicinano e allontanano. W, A, S, D o due dita spostano. Le parentesi quadre, Maiusc e le frecce, tre dita o due che ruotano girano la luce. Home ripristina."],ja:["\u30C9\u30E9\u30C3\u30B0\u3057\u3066\u56DE\u8EE2","\u8AAD\u307F\u8FBC\u307F\u4E2D","3D \u30AA\u30D6\u30B8\u30A7\u30AF\u30C8","{name} \u304C\u8868\u793A\u3055\u308C\u307E\u3057\u305F","\u3053\u3053\u3067\u306F\u30A4\u30F3\u30BF\u30E9\u30AF\u30C6\u30A3\u30D6\u8868\u793A\u3092\u5229\u7528\u3067\u304D\u307E\u305B\u3093\u3002","\u8AAD\u307F\u8FBC\u3081\u307E\u305B\u3093\u3067\u3057\u305F\u3002","\u6B63\u9762\u304B\u3089\u306E\u8868\u793A","\u53F3\u524D\u304B\u3089\u306E\u8868\u793A","\u53F3\u304B\u3089\u306E\u8868\u793A","\u53F3\u5F8C\u308D\u304B\u3089\u306E\u8868\u793A","\u5F8C\u308D\u304B\u3089\u306E\u8868\u793A","\u5DE6\u5F8C\u308D\u304B\u3089\u306E\u8868\u793A","\u5DE6\u304B\u3089\u306E\u8868\u793A","\u5DE6\u524D\u304B\u3089\u306E\u8868\u793A","\u3001\u4E0A\u304B\u3089","\u3001\u4E0B\u304B\u3089","\u77E2\u5370\u30AD\u30FC\u307E\u305F\u306F 1 \u672C\u6307\u3067\u56DE\u8EE2\u3057\u307E\u3059\u3002\u30D7\u30E9\u30B9\u3001\u30DE\u30A4\u30CA\u30B9\u307E\u305F\u306F\u30D4\u30F3\u30C1\u3067\u62E1\u5927\u30FB\u7E2E\u5C0F\u3057\u307E\u3059\u3002W\u3001A\u3001S\u3001D \u307E\u305F\u306F 2 \u672C\u6307\u3067\u79FB\u52D5\u3057\u307E\u3059\u3002\u89D2\u62EC\u5F27\u3001Shift \u3068\u77E2\u5370\u30AD\u30FC\u30013 \u672C\u6307\u3001\u307E\u305F\u306F 2 \u672C\u6307\u306E\u56DE\u8EE2\u3067\u5149\u3092\u56DE\u3057\u307E\u3059\u3002Home \u3067\u5143\u306B\u623B\u3057\u307E\u3059\u3002"],ko:["\uB4DC\uB798\uADF8\uD558\uC5EC \uD68C\uC804","\uBD88\uB7EC\uC624\uB294 \uC911","3D \uAC1C\uCCB4","{name} \uD45C\uC2DC\uB428","\uC5EC\uAE30\uC5D0\uC11C\uB294 \uB300\uD654\uD615 \uBCF4\uAE30\uB97C \uC0AC\uC6A9\uD560 \uC218 \uC5C6\uC2B5\uB2C8\uB2E4.","\uCF58\uD150\uCE20\uB97C \uBD88\uB7EC\uC62C \uC218 \uC5C6\uC2B5\uB2C8\uB2E4.","\uC55E\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5","\uC624\uB978\uCABD \uC55E\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5","\uC624\uB978\uCABD\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5","\uC624\uB978\uCABD \uB4A4\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5","\uB4A4\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5","\uC67C\uCABD \uB4A4\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5","\uC67C\uCABD\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5","\uC67C\uCABD \uC55E\uC5D0\uC11C \uBCF8 \uBAA8\uC2B5",", \uC704\uC5D0\uC11C",", \uC544\uB798\uC5D0\uC11C","\uD654\uC0B4\uD45C \uD0A4\uB098 \uD55C \uC190\uAC00\uB77D\uC73C\uB85C \uD68C\uC804\uD569\uB2C8\uB2E4. \uB354\uD558\uAE30, \uBE7C\uAE30 \uB610\uB294 \uD540\uCE58\uB85C \uD655\uB300\uD558\uACE0 \uCD95\uC18C\uD569\uB2C8\uB2E4. W, A, S, D \uB610\uB294 \uB450 \uC190\uAC00\uB77D\uC73C\uB85C \uC774\uB3D9\uD569\uB2C8\uB2E4. \uB300\uAD04\uD638, Shift\uC640 \uD654\uC0B4\uD45C \uD0A4, \uC138 \uC190\uAC00\uB77D \uB610\uB294 \uB450 \uC190\uAC00\uB77D \uD68C\uC804\uC73C\uB85C \uC870\uBA85\uC744 \uB3CC\uB9BD\uB2C8\uB2E4. Home\uC73C\uB85C \uCD08\uAE30\uD654\uD569\uB2C8\uB2E4."],nl:["Sleep om te draaien","Laden","Een 3D-object","{name} wordt getoond","De interactieve weergave is hier niet beschikbaar.","De inhoud kon niet worden geladen.","Vooraanzicht","Aanzicht van rechtsvoor","Aanzicht van rechts","Aanzicht van rechtsachter","Achteraanzicht","Aanzicht van linksachter","Aanzicht van links","Aanzicht van linksvoor",", van boven",", van onderen","Pijltoetsen of \xE9\xE9n vinger draaien. Plus, min of knijpen zoomen. W, A, S, D of twee vingers verschuiven. Vierkante haken, Shift en pijltoetsen, drie vingers of twee die draaien, draaien het licht. Home herstelt."],pt:["Arraste para girar","Carregando","Um objeto 3D","{name} est\xE1 vis\xEDvel","A visualiza\xE7\xE3o interativa n\xE3o est\xE1 dispon\xEDvel aqui.","N\xE3o foi poss\xEDvel carregar o conte\xFAdo.","Vista frontal","Vista frontal direita","Vista da direita","Vista traseira direita","Vista traseira","Vista traseira esquerda","Vista da esquerda","Vista frontal esquerda",", de cima",", de baixo","As setas ou um dedo giram a vista. Mais, menos ou uma pin\xE7a aproximam e afastam. W, A, S, D ou dois dedos deslocam. Colchetes, Shift e setas, tr\xEAs dedos ou dois que giram movem a luz. Home restaura a vista."],zh:["\u62D6\u52A8\u4EE5\u65CB\u8F6C","\u6B63\u5728\u52A0\u8F7D","\u4E09\u7EF4\u7269\u4F53","\u5DF2\u663E\u793A{name}","\u6B64\u5904\u65E0\u6CD5\u4F7F\u7528\u4EA4\u4E92\u5F0F\u89C6\u56FE\u3002","\u65E0\u6CD5\u52A0\u8F7D\u5185\u5BB9\u3002","\u6B63\u9762\u89C6\u56FE","\u53F3\u524D\u65B9\u89C6\u56FE","\u53F3\u4FA7\u89C6\u56FE","\u53F3\u540E\u65B9\u89C6\u56FE","\u80CC\u9762\u89C6\u56FE","\u5DE6\u540E\u65B9\u89C6\u56FE","\u5DE6\u4FA7\u89C6\u56FE","\u5DE6\u524D\u65B9\u89C6\u56FE","\uFF0C\u4FEF\u89C6","\uFF0C\u4EF0\u89C6","\u65B9\u5411\u952E\u6216\u5355\u6307\u65CB\u8F6C\u3002\u52A0\u53F7\u3001\u51CF\u53F7\u6216\u53CC\u6307\u5F20\u5408\u7F29\u653E\u3002W\u3001A\u3001S\u3001D \u6216\u53CC\u6307\u5E73\u79FB\u3002\u65B9\u62EC\u53F7\u3001Shift \u52A0\u65B9\u5411\u952E\u3001\u4E09\u6307\u6216\u53CC\u6307\u626D\u8F6C\u53EF\u8F6C\u52A8\u5149\u7EBF\u3002Home \u952E\u590D\u4F4D\u3002"]};function ea(r){let e=null;try{e=JSON.parse(r)}catch{}if(!(e!==null&&typeof e=="object"&&Object.entries(e).every(([n,s])=>lr.includes(n)&&typeof s=="string")))throw new Error(`expected a JSON object of texts called ${lr.join(", ")}, found ${JSON.stringify(r)}`);return e}function Ze(r,e,t={}){let n=r.settings.texts??{},s=Object.keys(_s).find(a=>r.matches(`:lang(${a})`))??"en";return(n[e]??_s[s][lr.indexOf(e)]).replace(/\{(\w+)\}/g,(a,o)=>t[o]??a)}var Ke=Math.PI/180,Jc={deg:Ke,rad:1},Qc={m:1,cm:.01,mm:.001},eu={"%":.01};function Yt(r,e){throw new Error(`expected ${r}, found ${JSON.stringify(e)}`)}function bs(r,e){let[,t,n]=/^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)([a-z%]+)$/i.exec(r)??[];return Object.hasOwn(e,n??"")?Number(t)*e[n]:null}function An(r,e,t){let n=r.trim().split(/\s+/);return n.length!==t.length&&Yt(e,r),n.map((s,i)=>s==="auto"?null:t[i](s)??Yt(e,r))}var Kt=r=>bs(r,Jc),cr=r=>bs(r,Qc),Mt=(r,e,t=!1)=>n=>{let s=Number(n);return n.trim()!==""&&s>=r&&s<=e&&(!t||Number.isInteger(s))?s:Yt(`a ${t?"whole ":""}number from ${r} to ${e}`,n)},it=(...r)=>e=>r.includes(e)?e:Yt(r.join(" or "),e),vs=r=>r,xn=r=>r.trim()||null,Ye=r=>r!=="false";function ys(r){let e=a=>cr(a)??bs(a,eu),[t,n,s]=An(r,"THETA PHI RADIUS, as 45deg 75deg 2m",[Kt,Kt,e]),i=r.trim().endsWith("%");return{azimuth:t,elevation:n===null?null:Ji(Math.PI/2-n),distance:i?null:s,share:i?s:null}}var xs=r=>An(r,"X Y Z, as 0m 0.5m 0m",[cr,cr,cr]);function ws(r){let[e]=An(r,"an angle, as 30deg",[Kt]);return e===null?null:Math.min(170,Math.max(1,e/Ke))}var ta=r=>An(r,"an angle, as 90deg",[Kt])[0]/Ke;function tu(r){if(r.trim()==="none")return{sun:0};let e=i=>i>=0?Number(i):null,[t,n,s]=An(r,"none or AZIMUTH HEIGHT BRIGHTNESS, as 40deg 45deg 2",[Kt,Kt,e]);return{sunAzimuth:(t??40*Ke)/Ke,sunHeight:(n??45*Ke)/Ke,sun:s??2}}function nu(r){let e=r.trim().split(/\s+/).filter(Boolean).map(t=>[t.slice(0,t.indexOf("=")),t.slice(t.indexOf("=")+1)]);return e.some(([t,n])=>!t||!n)&&Yt("LABEL=ADDRESS ..., as label=label-de.png",r),Object.fromEntries(e)}function ru(r){let e=r.trim().split(/\s+/).map(Number),t=globalThis.CSS?.supports("color",r);return e.length===3&&e.every(n=>n>=0&&n<1/0)?e:t&&sr(r)||Yt("a colour, or R G B of linear light, as 1 0.5 0.2",r)}var at={src:xn,glass:xn,alt:vs,poster:xn,scene:xn,environment:xn,tier:vs,"variant-name":vs,loading:it("auto","lazy","eager"),reveal:it("auto","manual"),"camera-orbit":ys,"camera-target":xs,"field-of-view":ws,"min-camera-orbit":ys,"max-camera-orbit":ys,"min-field-of-view":ws,"max-field-of-view":ws,sun:tu,"light-rotation":ta,"environment-intensity":Mt(0,1e6),ground:Ye,skybox:Ye,exposure:Mt(-30,30),"view-transform":it("srgb","filmic"),"camera-controls":Ye,"disable-zoom":Ye,"disable-pan":Ye,"disable-light":Ye,"touch-action":it("pan-y","pan-x","none"),"wheel-zoom":it("focus","always"),"interaction-prompt":it("auto","none"),"interpolation-decay":Mt(0,1e5),"auto-rotate":Ye,"auto-rotate-delay":Mt(0,1e9),"rotation-per-second":ta,samples:Mt(1,1e6,!0),"pixel-ratio":Mt(.1,8),jitter:Mt(0,1),"first-look":it("auto","off"),maps:nu,tint:ru,messages:it("calm","whole"),texts:ea},Xt=r=>r.replace(/-(.)/g,(e,t)=>t.toUpperCase()),ur=r=>String(Number(r.toPrecision(6))),Zt=r=>`${ur(r)}deg`,na=r=>`${ur(r)}m`;function En({azimuth:r,elevation:e,distance:t,target:n,fov:s}){let i=r/Ke,a=i-360*Math.round(i/360);return{cameraOrbit:`${Zt(a)} ${Zt(90-e/Ke)} ${na(t)}`,cameraTarget:n.map(na).join(" "),fieldOfView:Zt(s)}}function fr({rotation:r,strength:e,suns:t,sun:n,sunAzimuth:s,sunHeight:i}){return{sun:t||!(n>0)?"none":`${Zt(s)} ${Zt(i)} ${ur(n)}`,lightRotation:Zt(r),environmentIntensity:ur(e)}}var As={note:"Generated by `python -m rna_gpu.records.write_records`; do not edit.",constants:{MAX_LAYERS:32,MAX_EXACT_INPUTS:512,UNIFORM_WEIGHTS:4096,RNA_NONE:4294967295,RNA_FLOAT32:0,RNA_FLOAT16:1,RNA_INT8:2,RNA_BLOCK_FEATURES:0,RNA_BLOCK_POSITION:1,RNA_BLOCK_NORMAL:2,RNA_BLOCK_TANGENT:3,RNA_BLOCK_H:4,RNA_BLOCK_WO:5,RNA_BLOCK_WI:6,RNA_BLOCK_HALF_VECTOR:7,RNA_BLOCK_HIGHLIGHT:8,RNA_BLOCK_LEARNED_NORMAL:9,RNA_BLOCK_FIBER_ANGLES:10,RNA_BLOCK_FIBER_LOBES:11,RNA_CHANNEL_GROUPS:16,RNA_NOTHING:4294967295,RNA_IS_SEGMENT:1,RNA_SURFACE_SHIFT:1,RNA_HAS_BEFORE:1,RNA_HAS_AFTER:2,NONE:4294967295,SUM_BEAUTY:0,SUM_NORMAL:1,SUM_POSITION:2,SUM_LIGHT_SAMPLES:3,SUM_BEHIND:4,IS_LIGHT:2147483648,MATERIAL_PART:4294967294,CATCHER_PART:4294967293,SUM_GROUPS:5,CAMERA_RAY:1,INDIRECT_RAY:2,SHADOW_RAY:4,ALL_DIRECTIONS:4294967295,HEMISPHERE:4294967294,CHOICES:1,DIRECTION:2,ROULETTE:3,LIGHT:4,NEARBY:2097152,LENS:1048576,DIMENSIONS:7,HAS_SKY:1,FOR_BETA:2,RAYS_MEET_LIGHTS:4,FOR_EMISSION:8,FOR_LIGHT:16,TRANSMITS:32,FOR_VISIBLE:64,FOR_SHADOWED:128,OF_MATERIAL:0,OF_NEURAL:1,OF_FIBERS:2,EMITS:1,FRONT_ALONE:64,BACK_ALONE:128,LETS_THROUGH:2,IS_GLASS:4,HAS_CUTOFF:8,HAS_SCHLICK:16,IS_SOLID:32,BASE:0,METAL:1,COAT:2,GLOW:3,CLEAR:4,CLEAR_ROUGH:5,THROUGH:6,RELIEF:7,LIGHT_SEEN:1,LIGHT_DELTA:2,LIGHT_INFINITE:4,DIRECTIONAL:0,DISK:1,IMAGE:2,POINT:3,RECTANGLE:4,SPHERE:5,SPOT:6,SUN:7,TRIANGLES:8,UNIFORM:9},records:{RnaLayer:{words:8,members:{inputs:{at:0,type:"u32",count:1},outputs:{at:1,type:"u32",count:1},weights:{at:2,type:"u32",count:1},bias:{at:3,type:"u32",count:1},units:{at:4,type:"u32",count:1},relu:{at:5,type:"u32",count:1},int8_step:{at:6,type:"f32",count:1},reserved:{at:7,type:"u32",count:1}}},RnaPart:{words:496,members:{low:{at:0,type:"f32",count:3},resolution:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},channel_groups:{at:7,type:"u32",count:1},query_groups:{at:8,type:"u32",count:1},layer_count:{at:9,type:"u32",count:1},plane_precision:{at:10,type:"u32",count:1},gain:{at:11,type:"u32",count:1},query_low:{at:12,type:"f32",count:1},query_high:{at:13,type:"f32",count:1},top:{at:14,type:"f32",count:1},unit:{at:15,type:"f32",count:1},matrix:{at:16,record:"RnaLayer",count:1},scales:{at:24,type:"f32",count:192},layers:{at:216,record:"RnaLayer",count:32},slots:{at:472,type:"u32",count:12},factors:{at:484,type:"u32",count:1},nearby_columns:{at:485,type:"u32",count:1},means:{at:488,type:"f32",count:8}}},RnaRow:{words:20,members:{position:{at:0,type:"u32",count:3},h:{at:3,type:"u32",count:1},axis:{at:4,type:"u32",count:3},red:{at:7,type:"u32",count:1},wo:{at:8,type:"u32",count:3},green:{at:11,type:"u32",count:1},wi:{at:12,type:"u32",count:3},blue:{at:15,type:"u32",count:1},nearby:{at:16,type:"u32",count:3},has_nearby:{at:19,type:"u32",count:1}}},RnaNode:{words:8,members:{low:{at:0,type:"f32",count:3},child:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},count:{at:7,type:"u32",count:1}}},RnaPrimitive:{words:4,members:{a:{at:0,type:"u32",count:1},b:{at:1,type:"u32",count:1},c:{at:2,type:"u32",count:1},tag:{at:3,type:"u32",count:1}}},RnaInstance:{words:32,members:{to_object:{at:0,type:"f32",count:12},rotation:{at:12,type:"f32",count:12},place:{at:24,type:"f32",count:3},scale:{at:27,type:"f32",count:1},root:{at:28,type:"u32",count:1},rays:{at:29,type:"u32",count:1},extent:{at:30,type:"f32",count:1},host_data:{at:31,type:"u32",count:1}}},Frame:{words:52,members:{camera:{at:0,type:"f32",count:3},width:{at:3,type:"u32",count:1},corner:{at:4,type:"f32",count:3},paths:{at:7,type:"u32",count:1},step_x:{at:8,type:"f32",count:3},sample:{at:11,type:"u32",count:1},step_y:{at:12,type:"f32",count:3},seed:{at:15,type:"u32",count:1},depth:{at:16,type:"u32",count:1},light:{at:17,type:"u32",count:1},part:{at:18,type:"u32",count:1},parts:{at:19,type:"u32",count:1},rays:{at:20,type:"u32",count:1},clamp:{at:21,type:"f32",count:1},light_count:{at:22,type:"u32",count:1},sums:{at:23,type:"u32",count:1},flags:{at:24,type:"u32",count:1},branch:{at:25,type:"u32",count:1},branches:{at:26,type:"u32",count:1},neural_part:{at:27,type:"u32",count:1},list:{at:28,type:"u32",count:1},next_list:{at:29,type:"u32",count:1},table_size:{at:30,type:"u32",count:1},objects:{at:31,type:"u32",count:1},surfaces:{at:32,type:"u32",count:1},lights:{at:33,type:"u32",count:1},albedo:{at:34,type:"u32",count:1},domains:{at:35,type:"u32",count:1},textures:{at:36,type:"u32",count:1},spread:{at:37,type:"f32",count:1},lens_x:{at:40,type:"f32",count:3},focus:{at:43,type:"f32",count:1},lens_y:{at:44,type:"f32",count:3},lengths:{at:48,type:"f32",count:3}}},Path:{words:24,members:{origin:{at:0,type:"f32",count:3},pixel:{at:3,type:"u32",count:1},direction:{at:4,type:"f32",count:3},pdf:{at:7,type:"f32",count:1},beta:{at:8,type:"f32",count:3},state:{at:11,type:"u32",count:1},normal:{at:12,type:"f32",count:3},t:{at:15,type:"f32",count:1},instance:{at:16,type:"u32",count:1},primitive:{at:17,type:"u32",count:1},ignored:{at:18,type:"u32",count:1},b1:{at:19,type:"f32",count:1},leaving:{at:20,type:"f32",count:3},b2:{at:23,type:"f32",count:1}}},Query:{words:32,members:{x:{at:0,type:"f32",count:3},h:{at:3,type:"f32",count:1},axis:{at:4,type:"f32",count:3},part:{at:7,type:"u32",count:1},wo:{at:8,type:"f32",count:3},light:{at:11,type:"u32",count:1},wi:{at:12,type:"f32",count:3},strand:{at:15,type:"u32",count:1},weight:{at:16,type:"f32",count:3},seen:{at:19,type:"f32",count:1},visible:{at:20,type:"f32",count:3},far:{at:23,type:"f32",count:1},base_color:{at:24,type:"f32",count:3},nearby:{at:28,type:"f32",count:3}}},PathQueries:{words:64,members:{at_point:{at:0,record:"Query",count:1},at_light:{at:32,record:"Query",count:1}}},Object:{words:4,members:{number:{at:0,type:"f32",count:1},catches:{at:1,type:"u32",count:1},passes:{at:2,type:"u32",count:1},free:{at:3,type:"u32",count:1}}},Surface:{words:48,members:{kind:{at:0,type:"u32",count:1},part:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},normal_map:{at:3,type:"u32",count:1},base_color:{at:4,type:"f32",count:3},roughness:{at:7,type:"f32",count:1},metallic:{at:8,type:"f32",count:1},coat_f0:{at:9,type:"f32",count:1},coat_weight:{at:10,type:"f32",count:1},transmission:{at:11,type:"f32",count:1},emission:{at:12,type:"f32",count:3},normal_scale:{at:15,type:"f32",count:1},clear_coat:{at:16,type:"f32",count:1},clear_coat_roughness:{at:17,type:"f32",count:1},second_uvs:{at:18,type:"u32",count:1},tangents:{at:19,type:"u32",count:1},colors:{at:20,type:"u32",count:1},textures:{at:24,type:"u32",count:8},through:{at:32,type:"u32",count:1},cutoff:{at:33,type:"f32",count:1},ior:{at:34,type:"f32",count:2},absorption:{at:36,type:"f32",count:3},f0:{at:39,type:"f32",count:1},lobe_shares:{at:40,type:"f32",count:4},lobe_widths:{at:44,type:"f32",count:4}}},Texture:{words:12,members:{place:{at:0,type:"u32",count:1},size:{at:1,type:"u32",count:1},form:{at:2,type:"u32",count:1},row_u:{at:4,type:"f32",count:3},row_v:{at:8,type:"f32",count:3}}},Light:{words:32,members:{kind:{at:0,type:"u32",count:1},group:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},instance:{at:3,type:"u32",count:1},numbers:{at:4,type:"f32",count:20},probability:{at:24,type:"f32",count:3},places:{at:28,type:"u32",count:4}}}},lights:{directional:{colour:0,axis:3},disk:{colour:0,frame:3,radius:15},image:{colour:0,turn_cosine:3,turn_sine:4,total:5,mean:6,rows:7,columns:8},point:{colour:0,place:3},rectangle:{colour:0,frame:3,half:15},sphere:{colour:0,centre:3,radius:6},spot:{colour:0,place:3,axis:6,cos_inner:9,cos_outer:10},sun:{colour:0,axis:3,one_minus_cosine:6},triangles:{colour:0,rotation:3,place:12,scale:15},uniform:{colour:0}},usualLobes:{surface:{lobe_shares:[.5,.22,.07,.04],lobe_widths:[1,.1,.025,.004]},fiber:{lobe_shares:[.25,.45,0,0],lobe_widths:[.45,.06,1,1]}},viewerLights:{sun:0,environment:1,given:2,aroundPoint:3,mirror:4}};var{constants:oe,records:ie,usualLobes:ra,viewerLights:Es}=As;function sa(r){for(let[,e,t]of r.matchAll(/struct (\w+) \{([^}]*)\}/g)){let n={},s=0;for(let[,i,a]of t.matchAll(/^\s*(\w+): ([\w<>]+)/gm)){let o=Number(/vec(\d)/.exec(a)?.[1]??1),l=o===3?4:o,u=Math.ceil(s/l)*l;n[i]={at:u,type:a.includes("u32")?"u32":"f32",count:o},s=u+o}ie[e]={words:4*Math.ceil(s/4),members:n}}}function pe(r,e){let t=new Uint32Array(ie[r].words);return oa(t,new Float32Array(t.buffer),0,r,e),t}var ia=Object.entries(Es).map(([r,e])=>`const LIGHT_${r.replace(/[A-Z]/g,"_$&").toUpperCase()}: u32 = ${e}u;`).join(`
`),ot=r=>4*ie[r].words;function aa(r,e){let t=[];for(let[n,s]of Object.entries(e))[s].flat().forEach((i,a)=>{t[As.lights[r][n]+a]=i});return Float32Array.from(t,n=>n??0)}function oa(r,e,t,n,s){for(let[i,a]of Object.entries(s)){let{at:o,type:l,record:u}=ie[n].members[i],f=t+o,p=typeof a=="number"?[a]:a;u?[p].flat().forEach((m,g)=>oa(r,e,f+g*ie[u].words,u,m)):(l==="f32"?e:r).set(p,f)}}var{RNA_IS_SEGMENT:iu}=oe,{words:au,members:hr}=ie.RnaNode,{words:ou,members:Ss}=ie.RnaPrimitive,lu=1;function pr({nodes:r,primitives:e,points:t},n,s){let i=new Float32Array(r.buffer,r.byteOffset,r.length),a=[lu],o=null;for(;a.length;){let u=a.pop(),f=au*u,p=r[f+hr.child.at],m=r[f+hr.count.at];if(cu(i,f,n,s,o?.distance??1/0)){m||a.push(p,u+1);for(let g=0;g<m;g++){let _=e.subarray(ou*(p+g)),A=(_[Ss.tag.at]&iu?fu:uu)(_,t,n,s);A&&A.distance<(o?.distance??1/0)&&(o=A)}}}if(!o)return null;let l=X(o.normal,s)>0?-1:1;return{distance:o.distance,position:de(n,s,o.distance),normal:st(Ot(o.normal),l)}}function cu(r,e,t,n,s){let i=0,a=s;for(let o=0;o<3;o++){let l=r[e+hr.low.at+o]-t[o],u=r[e+hr.high.at+o]-t[o];if(n[o]===0){if(l>0||u<0)return!1;continue}let f=l/n[o],p=u/n[o];i=Math.max(i,Math.min(f,p)),a=Math.min(a,Math.max(f,p))}return i<=a}var Rs=(r,e)=>[r[4*e],r[4*e+1],r[4*e+2]];function uu(r,e,t,n){let[s,i,a]=["a","b","c"].map(A=>Rs(e,r[Ss[A].at])),o=Ee(i,s),l=Ee(a,s),u=Tt(n,l),f=X(o,u);if(f===0)return null;let p=Ee(t,s),m=Tt(p,o),g=X(p,u)/f,_=X(n,m)/f,w=X(l,m)/f;return g>=0&&_>=0&&g+_<=1&&w>0?{distance:w,normal:Tt(o,l)}:null}function fu(r,e,t,n){let s=r[Ss.a.at],i=Rs(e,s),a=Ee(Rs(e,s+1),i),o=Ee(t,i),l=X(a,a),u=X(a,n),f=l-u*u,p=f>0?(X(o,a)-u*X(o,n))/f:0,m=Math.min(1,Math.max(0,p)),g=de(i,a,m),_=X(Ee(g,t),n),w=Ee(de(t,n,_),g),A=e[4*s+3]+m*(e[4*s+7]-e[4*s+3]),T=A*A-X(w,w);if(T<0)return null;let F=_-Math.sqrt(T);return F>0?{distance:F,normal:Ee(de(t,n,F),g)}:null}var hu=.002,pu={childList:!0,subtree:!0,attributes:!0,attributeFilter:["slot","data-position","data-normal"]};function ca({corner:r,stepX:e,stepY:t,width:n,height:s},i,a){return Ot(r.map((o,l)=>o+i*n*e[l]+a*s*t[l]))}function mu({position:r,corner:e,stepX:t,stepY:n,width:s,height:i},a){let o=t.map(g=>g*s),l=n.map(g=>g*i),u=Ee(a,r),f=(g,_)=>X(_,g)/X(g,g),p=e.map((g,_)=>g+.5*(o[_]+l[_])),m=f(p,u);return m>0?[.5+f(o,u)/m,.5+f(l,u)/m]:null}var mr=class{constructor(e,t,n){Object.assign(this,{host:e,place:t,stage:n}),new MutationObserver(()=>this.update()).observe(e,pu),n.addEventListener("shown",()=>this.update())}_known(){let e=new Map,t=[];for(let n of this.host.querySelectorAll(':scope > [slot^="hotspot"]'))try{let{position:s,normal:i}=n.dataset;e.set(n,{position:la(s??""),normal:i===void 0?null:la(i)})}catch(s){t.push(`${n.slot}: ${s.message}`)}return this.stage.notices.say(t.join("; "),!0,"hotspots"),e}update(){let e=this._known(),t=new Set([...e.keys()].map(({slot:s})=>s)),n=this.stage.shownCamera;for(let s of[...this.place.children])t.has(s.name)||s.remove();for(let[s,i]of e){let a=this._slot(s.slot),o=n&&mu(n,i.position),l=!!o&&this._isSeen(n,i);a.classList.toggle("unseen",!l),o&&Object.assign(a.style,{left:`${100*o[0]}%`,top:`${100*o[1]}%`}),s.dataset.visibilityAttribute&&s.toggleAttribute(`data-${s.dataset.visibilityAttribute}`,l)}}_slot(e){let t=[...this.place.children].find(s=>s.name===e);if(t)return t;let n=Object.assign(document.createElement("slot"),{name:e});return this.place.append(n),n}_isSeen({position:e},t){let n=Ee(t.position,e),s=Math.hypot(...n);if(t.normal&&X(t.normal,n)>=0)return!1;let{hitArrays:i}=this.stage,a=i&&pr(i,e,Ot(n));return!a||a.distance>(1-hu)*s}};function la(r){let e=xs(r);if(e.includes(null))throw new Error(`expected X Y Z, as 0m 0.5m 0m, found ${JSON.stringify(r)}`);return e}var ks="nothing: assets stay as they were made",Lt="nothing: there is no AR",Ns={"environment-image":"environment","skybox-image":"environment with skybox","skybox-height":"skybox, of which the image is far away","shadow-intensity":"ground, on an opaque background-color","shadow-softness":"ground, whose shadow is as soft as the lights are wide","tone-mapping":"view-transform",autoplay:ks,"animation-name":ks,"animation-crossfade-duration":ks,ar:Lt,"ar-modes":Lt,"ar-scale":Lt,"ar-placement":Lt,"ar-usdz-max-texture-size":Lt,"ios-src":Lt,"xr-environment":Lt,orientation:"camera-orbit, or light-rotation",scale:"camera-orbit, whose radius says how near","with-credentials":"nothing: files are asked for with the cookies of their own site alone","disable-tap":"nothing: a tap moves no camera","interaction-prompt-threshold":"interaction-prompt","interaction-prompt-style":"interaction-prompt",bounds:"nothing: the whole asset is framed","orbit-sensitivity":"nothing: a gesture has one speed","zoom-sensitivity":"nothing: a gesture has one speed","pan-sensitivity":"nothing: a gesture has one speed","min-hotspot-opacity":"data-visibility-attribute, and CSS","max-hotspot-opacity":"data-visibility-attribute, and CSS","generate-schema":"nothing",a11y:"texts"};function ua(r){let e=r.filter(t=>Object.hasOwn(Ns,t)).map(t=>`no attribute ${t}, which is model-viewer's; here it is ${Ns[t]}`);return e.length&&r.includes("exposure")&&e.push("exposure is in stops, where model-viewer's is a factor: its 1 is 0 here"),e}var fa=r=>Object.hasOwn(Ns,r);function me(r,e,...t){let n=document.createElement(r);for(let[s,i]of Object.entries(e))n.setAttribute(s,i);return n.append(...t),n}var du=()=>[me("i",{id:"tint"}),me("div",{id:"view",part:"view"}),me("div",{id:"hotspots"}),me("slot",{}),me("div",{id:"poster"},me("slot",{name:"poster"},me("img",{part:"poster",alt:"",hidden:""}))),me("div",{id:"over"},me("div",{id:"loading",hidden:""},me("slot",{name:"progress-bar"},me("progress",{id:"bar",part:"progress-bar"}),me("span",{id:"bytes"}))),me("p",{id:"prompt",part:"prompt","aria-hidden":"true",hidden:""}),me("p",{id:"notice",part:"notice",role:"status",hidden:""})),me("p",{id:"keys",class:"spoken"}),me("p",{id:"status",class:"spoken",role:"status"})],gu=`
:host {
  display: block; position: relative; overflow: hidden; width: 100%; aspect-ratio: 16 / 10;
  background-color: rgb(64, 67, 71); color: #fff; font: 13px/1.45 system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif;
}
:host([hidden]), [hidden] { display: none !important; }
#view, canvas, #poster, #poster img, ::slotted([slot="poster"]) { position: absolute; inset: 0; width: 100%; height: 100%; }
#tint { position: absolute; background-color: inherit; transition: background-color 1ms; }
canvas { display: block; }
#view > :last-child { transition: opacity 0.3s; }
#view.standing > :last-child { opacity: 0; transition: none; }
#view:has(~ #poster:not([hidden]) img:not([hidden])) canvas { filter: opacity(0); }
canvas:focus-visible { outline: none; }
#view:has(> :focus-visible)::after { content: ""; position: absolute; inset: 0; outline: 2px solid #fff; outline-offset: -2px; pointer-events: none; }
:host([camera-controls]:not([camera-controls="false"])) canvas { cursor: grab; }
:host([camera-controls]:not([camera-controls="false"])) canvas.dragging { cursor: grabbing; }
#hotspots { position: absolute; inset: 0; pointer-events: none; }
#hotspots slot { display: flex; position: absolute; transform: translate(-50%, -50%); pointer-events: auto; }
#hotspots .unseen { visibility: hidden; }
#poster { pointer-events: none; }
::slotted([slot="poster"]) { pointer-events: auto; }
#poster img { object-fit: contain; }
#over {
  position: absolute; inset: 0; padding: 16px; pointer-events: none; overflow: hidden; box-sizing: border-box;
  display: flex; flex-direction: column; justify-content: flex-end; align-items: center; gap: 10px;
}
#loading { text-align: center; font-variant-numeric: tabular-nums; }
#bar {
  display: block; width: min(60vw, 320px); max-width: 100%; height: 4px; margin-bottom: 6px; border: 0; border-radius: 2px;
  appearance: none; background: #3a3a3a;
}
#bar::-webkit-progress-bar { background: #3a3a3a; border-radius: 2px; }
#bar::-webkit-progress-value { background: #cfcfcf; border-radius: 2px; }
#bar::-moz-progress-bar { background: #cfcfcf; border-radius: 2px; }
#notice {
  max-width: min(100%, 60ch); margin: 0; padding: 10px 16px; border-radius: 6px; pointer-events: auto; text-align: center;
  background: #7a2525; border: 1px solid #a34a4a; overflow-wrap: anywhere;
}
#notice.calm { background: #000c; border-color: #555; }
#notice span { display: block; }
#prompt {
  margin: 0 0 8%; padding: 6px 16px; border-radius: 999px; background: #000a; animation: prompt 4s ease-in-out infinite;
}
@keyframes prompt { 0%, 100% { transform: translateX(-24px); opacity: 0; } 20%, 80% { opacity: 1; } 50% { transform: translateX(24px); } }
.spoken { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`,dr=new WeakMap;function ha(r){let e=r.attachShadow({mode:"open",delegatesFocus:!0});return Is(e),e.append(...du()),e}function Is(r){let e=r.ownerDocument.defaultView;e&&(dr.has(e)||(dr.set(e,new e.CSSStyleSheet),dr.get(e).replaceSync(gu)),r.adoptedStyleSheets=[dr.get(e)])}var _u=["front","front-right","right","back-right","back","back-left","left","front-left"],pa=20*Math.PI/180;function ma({azimuth:r,elevation:e},t){let n=Math.round(4*r/Math.PI),s=_u[(n%8+8)%8],i=e>pa?t("above"):e<-pa?t("below"):"";return t(s)+i}function*Pt(r,e,t){for(let n=r;n<e;n+=8192)t(n,Math.min(e,n+8192)),n+8192<e&&(yield)}async function lt(r){for(let e=performance.now();;){let{done:t,value:n}=r.next();if(t)return n;performance.now()-e<20||(await vu(),e=performance.now())}}function vu(){let{port1:r,port2:e}=new MessageChannel;return new Promise(t=>{r.onmessage=()=>{r.close(),t()},e.postMessage(null)})}var{words:Ts,members:Rn}=ie.RnaNode,Xe=16,yu=4,da=256,wu=24;function*Fs(r,e=0,t=0){let n=r.length/6,s=Uint32Array.from({length:n},(p,m)=>m),i=new Float32Array(3*n);for(let p=0;p<n;p++)for(let m=0;m<3;m++)i[3*p+m]=.5*(r[6*p+m]+r[6*p+3+m]);let a=new Float32Array(2*Ts*n),o=new Uint32Array(a.buffer),l={boxes:r,centres:i,order:s},u=[[0,n,0,-1]],f=0;for(;u.length;){let[p,m,g,_]=u.pop(),w=Ts*f;f+=1,_>=0&&(o[_+Rn.child.at]=e+f-1),m-p>da&&(yield),bu(l,p,m);for(let F=0;F<3;F++)a[w+Rn.low.at+F]=Re[F],a[w+Rn.high.at+F]=Re[3+F];if(m-p<=yu){o[w+Rn.child.at]=t+p,o[w+Rn.count.at]=m-p;continue}let A={cost:1/0};for(let F=0;F<3&&g<wu;F++){let G=xu(l,p,m,F);G.cost<A.cost&&(A=G),m-p>da&&(yield)}let T=A.cost<1/0?Au(l,p,m,A):p;p<T&&T<m||(T=Eu(l,p,m)),u.push([T,m,g+1,w],[p,T,g+1,-1])}return{nodes:o.slice(0,Ts*f),order:s.map(p=>t+p)}}function Cs(r,e,t,n){for(let s=0;s<3;s++){let i=t[n+s],a=t[n+3+s];i<r[e+s]&&(r[e+s]=i),a>r[e+3+s]&&(r[e+3+s]=a)}}function zs(r){for(let e=0;e<r.length;e+=6)for(let t=0;t<3;t++)r[e+t]=1/0,r[e+3+t]=-1/0;return r}var Re=new Float32Array(6),Ls=new Float32Array(6*Xe),Ps=new Uint32Array(Xe),Os=new Float64Array(Xe),Ms=new Float64Array(Xe);function bu({boxes:r,order:e},t,n){zs(Re);for(let s=t;s<n;s++)Cs(Re,0,r,6*e[s])}function _a({centres:r,order:e},t,n,s){let i=1/0,a=-1/0;for(let o=t;o<n;o++){let l=r[3*e[o]+s];l<i&&(i=l),l>a&&(a=l)}return[i,a]}var va=(r,e,t)=>Math.min(Math.floor((r-e)/(t-e)*Xe),Xe-1);function xu(r,e,t,n){let{boxes:s,centres:i,order:a}=r,[o,l]=_a(r,e,t,n);if(!(l>o))return{cost:1/0};zs(Ls),Ps.fill(0);for(let p=e;p<t;p++){let m=va(i[3*a[p]+n],o,l);Ps[m]+=1,Cs(Ls,6*m,s,6*a[p])}ga(Ms,Xe-1,-1),ga(Os,0,1);let u=1/0,f=0;for(let p=1;p<Xe;p++)Os[p-1]+Ms[p]<u&&(u=Os[p-1]+Ms[p],f=p);return{cost:u,cut:f,axis:n,low:o,high:l}}function ga(r,e,t){zs(Re);for(let n=e,s=0;n>=0&&n<Xe;n+=t){Cs(Re,0,Ls,6*n),s+=Ps[n];let i=Re[3]-Re[0],a=Re[4]-Re[1],o=Re[5]-Re[2];r[n]=s?(i*a+a*o+o*i)*s:1/0}}function Au({centres:r,order:e},t,n,{axis:s,cut:i,low:a,high:o}){let l=t,u=n-1;for(;l<=u;){let f=e[l];va(r[3*f+s],a,o)<i?l++:(e[l]=e[u],e[u--]=f)}return l}function Eu(r,e,t){let{centres:n,order:s}=r,i=[0,1,2].map(o=>{let[l,u]=_a(r,e,t,o);return u-l}),a=i.indexOf(Math.max(...i));return s.subarray(e,t).sort((o,l)=>n[3*o+a]-n[3*l+a]),Math.floor((e+t)/2)}var _r=8192,Ru=[[137,80,78,71],[255,216,255],[82,73,70,70]],xa={colorSpaceConversion:"none",premultiplyAlpha:"none"};async function Aa(r,e){let t=Ru.some(a=>a.every((o,l)=>r[l]===o)),n=a=>b("BASE_COLOR_IMAGE",e,`found ${a}, expected a PNG, JPEG or WebP of 1 to ${_r} pixels a side`);t||n("another file");let s=Su(r);s||n("a file without a size, or in inks"),s.every(a=>a>=1&&a<=_r)||n(`${s.join(" x ")} pixels`),Ea(e);let i=await createImageBitmap(new Blob([Nu(r)]),xa).catch(()=>n("what cannot be decoded"));return Sa(i)}function Ea(r){if(!globalThis.createImageBitmap)throw new $(`${r}: expected a browser, which decodes images; there is no createImageBitmap here`)}function Su(r){let e=new DataView(r.buffer,r.byteOffset,r.length);try{if(r[0]===137)return[e.getUint32(16),e.getUint32(20)];if(r[0]===82)return ku(e);for(let t=2;;t+=2+e.getUint16(t+2)){let n=e.getUint16(t);if(n<65472||n===65498)return null;if(n<=65487&&![65476,65480,65484].includes(n))return[1,3].includes(e.getUint8(t+9))?[e.getUint16(t+7),e.getUint16(t+5)]:null}}catch{return null}}function ku(r){let e=s=>1+r.getUint16(s,!0)+65536*r.getUint8(s+2),t=String.fromCharCode(...[12,13,14,15].map(s=>r.getUint8(s)));if(t==="VP8X")return[e(24),e(27)];if(t==="VP8 ")return[r.getUint16(26,!0)&16383,r.getUint16(28,!0)&16383];if(t!=="VP8L")return null;let n=r.getUint32(21,!0);return[1+(n&16383),1+(n>>>14&16383)]}async function Ra(r){Ea("an image");let e=r instanceof ImageBitmap?r:await createImageBitmap(r,xa);if(Math.max(e.width,e.height)>_r)throw new Error(`an image of ${e.width} x ${e.height} pixels; at most ${_r} a side`);return Sa(e)}function Nu(r){let e=new DataView(r.buffer,r.byteOffset,r.length),t=r[0]===255;if(r[0]===82)return r;let n=[r.subarray(0,t?2:8)],s=n[0].length;for(;s+12<=r.length;){let i=e.getUint32(s+(t?0:4)),a=i>>>16;if(t&&(a<65472||a===65498))break;let o=s+(t?2+e.getUint16(s+2):12+e.getUint32(s));(t?a===65505:i===1700284774)||n.push(r.subarray(s,o)),s=o}return new Blob([...n,r.subarray(s)])}function Sa(r){let{width:e,height:t}=r,n=new OffscreenCanvas(1,1).getContext("webgl2"),s=new Uint8Array(4*e*t);if(!n)return{pixels:ya(r),width:e,height:t};n.bindTexture(n.TEXTURE_2D,n.createTexture()),n.texImage2D(n.TEXTURE_2D,0,n.RGBA8,n.RGBA,n.UNSIGNED_BYTE,r),n.bindFramebuffer(n.FRAMEBUFFER,n.createFramebuffer()),n.framebufferTexture2D(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,n.getParameter(n.TEXTURE_BINDING_2D),0),n.readPixels(0,0,e,t,n.RGBA,n.UNSIGNED_BYTE,s);let i=n.getError();return n.getExtension("WEBGL_lose_context")?.loseContext(),{pixels:i?ya(r):s,width:e,height:t}}function ya(r){let{width:e,height:t}=r,n=new OffscreenCanvas(e,t).getContext("2d");return n.drawImage(r,0,0),new Uint8Array(n.getImageData(0,0,e,t).data.buffer)}var wa=Array.from({length:256},(r,e)=>e/255),Iu={linear:Float32Array.from(wa),srgb:Float32Array.from(wa,r=>r<=.04045?r/12.92:((r+.055)/1.055)**2.4)};function*Us({pixels:r,width:e,height:t},n="srgb"){let s=Iu[n],i=Ou(s),a=[[e,t]];for(;Math.max(...a.at(-1))>1;)a.push(a.at(-1).map(f=>Math.max(1,f>>1)));let o=new Uint32Array(a.reduce((f,[p,m])=>f+p*m,0));o.set(new Uint32Array(r.buffer,r.byteOffset,e*t));let l=null,u=e*t;for(let f=1;f<a.length;f++){let p=a[f-1],m=a[f],_=yield*Tu(f===1?(w,A)=>s[r[4*w+A]]:(w,A)=>l[3*w+A],p,m);for(let w=0;w<m[0]*m[1];w++)o[u+w]=i(_[3*w])|i(_[3*w+1])<<8|i(_[3*w+2])<<16;u+=m[0]*m[1],l=_}return o}function*Tu(r,[e,t],[n,s]){let i=ba(e,n),a=ba(t,s),o=new Float32Array(3*n*s);return yield*Pt(0,n*s,(l,u)=>{for(let f=l;f<u;f++){let p=i[f%n],m=a[Math.floor(f/n)];for(let g=0;g<3;g++){let _=0;for(let w=0;w<m.shares.length;w++)for(let A=0;A<p.shares.length;A++)_+=p.shares[A]*m.shares[w]*r((m.first+w)*e+p.first+A,g);o[3*f+g]=_}}}),o}function ba(r,e){return Array.from({length:e},(t,n)=>{let s=n*r/e,i=(n+1)*r/e,a=Math.floor(s),o=Array.from({length:Math.min(r,Math.ceil(i))-a},(l,u)=>(Math.min(i,a+u+1)-Math.max(s,a+u))*e/r);return{first:a,shares:o}})}var gr=4096;function Ou(r){let e=r.subarray(1).map((n,s)=>(n+r[s])/2),t=new Uint8Array(gr+1);for(let n=0,s=0;n<=gr;n++){for(;s<255&&e[s]<n/gr;)s++;t[n]=s}return n=>{let s=t[Math.floor(n*gr)];for(;s<255&&e[s]<n;)s++;return s}}var{NONE:Ds,OF_MATERIAL:Mu,OF_NEURAL:Lu,OF_FIBERS:Pu,IS_SOLID:Fu,LETS_THROUGH:ka,HAS_CUTOFF:Cu,BASE:Bs}=oe,zu=["repeat","clamp","mirror"],Uu=256,Du=ie.Surface.members.textures.count,Na=new Uint32Array(0),vr=[1,1,1],Bu=[1,0,0,0,1,0],yr=class{#e=new Map;constructor(e){Object.assign(this,{surfaces:[],textures:[],pieces:[],tint:vr},e)}ofFibers({sampling:e},t){return this._add({kind:Pu,part:t,...e[0].lobes})}ofGlass(e){return e.map(({ior:t,tint:n,absorption:s})=>this._add({kind:Mu,flags:Fu,base_color:n,ior:[t,0],absorption:s}))}*ofTriangles({mesh:e,normalMaps:t,transmittance:n,baseColor:s,sampling:i},a){let o=e.indices.length/3,l=[t,n,s,Hu(i,o)],u=l.map(m=>Gu(m,o)),f=new Map,p=new Uint32Array(o);for(let m=0;m<o;m++){let g=u.map(w=>w[m]),_=g.join();f.has(_)||(f.set(_,yield*this._ofRecords(a,...l.map((w,A)=>w[g[A]]))),this.surfaces[f.get(_)].record=g[2]),p[m]=f.get(_)}return p}*reprint(e){for(let n of this.surfaces){let s=n.factor&&e[n.part][n.record];s&&(n.factor=s.factor??vr,n.textures[Bs]=s.image?yield*this._print(s):Ds)}let t=new Set(this.surfaces.map(({textures:n})=>n[Bs]));this.textures.forEach((n,s)=>{n.label!==void 0&&!t.has(s)&&delete n.label})}arrays(){let{surfaces:e,textures:t,pieces:n,tint:s}=this,i=[0];for(let u of n)i.push(i.at(-1)+u.length);let a=[...e.map(({factor:u,record:f,...p})=>pe("Surface",{...p,...u&&{base_color:u.map((m,g)=>m*s[g])}})),...t.map(({piece:u,width:f,height:p,form:m,row_u:g,row_v:_})=>pe("Texture",{place:i[u],size:p<<16|f,form:m,row_u:g,row_v:_}))],o=Uint32Array.from(a.flatMap(u=>[...u])),l=new Uint32Array(i.at(-1));return n.forEach((u,f)=>l.set(u,i[f])),{table:o,images:l,texturesAt:e.length*ie.Surface.words/4,hasBaseColor:e.some(({factor:u})=>u),transmits:e.some(({flags:u})=>u&ka)}}get labels(){return[...new Set(this.textures.map(({label:e})=>e).filter(e=>e!==void 0))]}async setImage(e,t){for(let n of this.textures.filter(s=>s.label===e)){let{piece:s,width:i,height:a}=n,o=t&&await lt(Us(t,n.colorSpace));n.first??={piece:s,width:i,height:a},n.given??=this.pieces.push(Na)-1,this.pieces[n.given]=o??Na,Object.assign(n,o?{piece:n.given,width:t.width,height:t.height}:n.first)}}_add(e){return this.surfaces.push({normal_map:Ds,base_color:vr,textures:Array(Du).fill(Ds),...e})-1}*_ofRecords(e,t,n,s,{lobes:i}){let a=this._add({kind:Lu,part:e,...i}),o=this.surfaces[a];return t&&(o.normal_map=this._texture(t.texture)),n&&(o.flags=ka|(n.cutoff==null?0:Cu),Object.assign(o,{through:this._texture(n.texture),cutoff:n.cutoff??0,ior:n.ior??[0,0]})),s&&(o.factor=s.factor??vr),s?.image&&(o.textures[Bs]=yield*this._print(s)),a}_texture({values:e,width:t,height:n,channels:s}){let i=new Uint32Array(t*n);for(let o=0;o<i.length;o++){let[l,u=l,f=s===1?l:0]=e.subarray(s*o,s*(o+1));i[o]=l|u<<8|f<<16}let a=this.pieces.push(i)-1;return this.textures.push({piece:a,width:t,height:n,form:0,row_u:[1,0,0],row_v:[0,1,0]})-1}*_print({image:e,label:t,colorSpace:n="srgb",wrap:s=["repeat","repeat"],transform:i=Bu}){let a=this.#e.get(e)??{},[o,l]=s.map(u=>zu.indexOf(u));return a[n]??=this.pieces.push(yield*Us(e,n))-1,this.#e.set(e,a),this.textures.push({piece:a[n],width:e.width,height:e.height,form:o|l<<2|(n==="srgb"?Uu:0),row_u:i.slice(0,3),row_v:i.slice(3),label:t,colorSpace:n})-1}};function Hu(r,e){return r.map(({first:t,lobes:n},s)=>({triangles:[t,(r[s+1]?.first??e)-t],lobes:n}))}function Gu(r,e){let t=new Int32Array(e).fill(-1);return r.forEach(({triangles:[n,s]},i)=>t.fill(i,n,n+s)),t}var{RNA_HAS_BEFORE:$u,RNA_HAS_AFTER:qu,RNA_IS_SEGMENT:ju,RNA_SURFACE_SHIFT:Oa}=oe,Sn=ie.RnaPrimitive,Jt=ie.RnaNode,wr=(r,e=null)=>lt(Vu(r,e));function*Vu(r,e){let t=[...r,...e?[e]:[]].map(Wu),n=_=>t.reduce((w,A)=>w+A[_],0),s={primitives:new Uint32Array(Sn.words*n("primitives")),points:new Float32Array(4*n("points")),normals:new Float32Array(4*n("normals")),boxes:new Float32Array(6*n("primitives")),surfaces:new yr,parts:[],extent:0,strands:0},i={primitive:0,point:0},a=[...r.keys()].sort((_,w)=>(r[_].kind==="fiber")-(r[w].kind==="fiber"));for(let _ of a){let w=r[_];s.parts[_]={first:i.primitive,point:i.point,fiber:w.kind==="fiber"},w.kind==="fiber"?yield*Zu(s,w,_,i):yield*Ia(s,w.mesh,yield*s.surfaces.ofTriangles(w,_),i),i={primitive:i.primitive+t[_].primitives,point:i.point+t[_].points}}if(e){let _=s.surfaces.ofGlass(e.materials);yield*Ia(s,e.mesh,e.materialOf.map(w=>_[w]),i)}let o=[yield*Fs(s.boxes.subarray(0,6*i.primitive),1)],l=e&&1+o[0].nodes.length/Jt.words;e&&o.push(yield*Fs(s.boxes.subarray(6*i.primitive),l,i.primitive));let u=Ta(o.map(({order:_})=>_)),f=new Uint32Array(s.primitives.length),p=new Uint32Array(u.length);yield*Pt(0,u.length,(_,w)=>{for(let A=_;A<w;A++){let T=u[A],F=s.primitives.subarray(Sn.words*T,Sn.words*(T+1));f.set(F,Sn.words*A),p[T]=A}});let m=Yu(o),g=Ta([m,...o.map(_=>_.nodes)]);return{...s,boxes:null,...s.surfaces.arrays(),primitives:f,nodes:g,where:p,glassRoot:l,box:La(m)}}function Wu({mesh:r,curves:e}){if(r){let n=r.positions.length/3;return{primitives:r.indices.length/3,points:n,normals:n}}let t=e.radii.length;return{primitives:t-(e.offsets.length-1),points:t,normals:0}}function*Ia(r,{positions:e,normals:t,uvs:n,indices:s},i,{primitive:a,point:o}){let{points:l,boxes:u,primitives:f}=r;yield*Pt(0,e.length/3,(p,m)=>{for(let g=p;g<m;g++){let _=4*(o+g);for(let w=0;w<3;w++)l[_+w]=e[3*g+w],r.normals[_+w]=t[3*g+w],r.extent=Math.max(r.extent,Math.abs(e[3*g+w]));l[_+3]=n?n[2*g]:0,r.normals[_+3]=n?n[2*g+1]:0}}),yield*Pt(0,s.length/3,(p,m)=>{for(let g=p;g<m;g++){let _=[0,1,2].map(F=>s[3*g+F]),[w,A,T]=_.map(F=>F+o);Ma(f,a+g,w,A,T,i[g]<<Oa);for(let F=0;F<3;F++){let G=_.map(te=>e[3*te+F]);u[6*(a+g)+F]=Math.min(...G),u[6*(a+g)+3+F]=Math.max(...G)}}})}function*Zu(r,e,t,{primitive:n,point:s}){let{boxes:i,primitives:a}=r,{curves:o}=e,{radii:l,offsets:u}=o,f=r.surfaces.ofFibers(e,t);yield*Pt(0,l.length,(m,g)=>{for(let _=m;_<g;_++){let[w,A,T]=o.points.subarray(3*_,3*_+3);r.points.set([w,A,T,l[_]],4*(s+_)),r.extent=Math.max(r.extent,Math.max(Math.abs(w),Math.abs(A),Math.abs(T))+l[_])}});let p=n;for(let m=0;m+1<u.length;m++,r.strands++){yield;for(let g=u[m];g+1<u[m+1];g++,p++){let _=(g>u[m]&&$u)|(g+2<u[m+1]&&qu);Ma(a,p,s+g,_,r.strands,f<<Oa|ju);for(let w=0;w<3;w++){let A=o.points[3*g+w],T=o.points[3*g+3+w],F=l[g]*1.0005,G=l[g+1]*1.0005;i[6*p+w]=Math.min(A-F,T-G),i[6*p+3+w]=Math.max(A+F,T+G)}}}}function Ma(r,e,t,n,s,i){let{members:a,words:o}=Sn,l=o*e;r[l+a.a.at]=t,r[l+a.b.at]=n,r[l+a.c.at]=s,r[l+a.tag.at]=i}function Yu(r){let{low:e,high:t,child:n,count:s}=Jt.members,i=new Uint32Array(Jt.words),a=new Float32Array(i.buffer),o=r.map(({nodes:l})=>La(l));for(let l=0;l<3;l++)a[e.at+l]=Math.min(...o.map(({min:u})=>u[l])),a[t.at+l]=Math.max(...o.map(({max:u})=>u[l]));return i[n.at]=0,i[s.at]=r.length,i}function Ta(r){let e=new Uint32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;for(let n of r)e.set(n,t),t+=n.length;return e}function La(r){let e=new Float32Array(r.buffer,0,Jt.words),t=({at:n,count:s})=>[...e.subarray(n,n+s)];return{min:t(Jt.members.low),max:t(Jt.members.high)}}var Pa=[1024,512];function Fa(r){let{rgb:e,width:t,height:n}=Ju(r),s=[0,e.length,e.length+n+1,e.length+2*n+3],i=new Float32Array(s[3]+(n+1)*(t+1));i.set(e);let a=l=>Math.cos(Math.PI*Math.min(1,Math.max(0,(l-.5)/n))),o=0;for(let l=0;l<=n;l++){let u=a(l)-a(l+1),f=t*Math.max(l-1,0),p=t*Math.min(l,n-1);i[s[1]+l]=u;let m=0;for(let g=0;g<t;g++){let _=(g+1)%t,w=[f+g,f+_,p+g,p+_].reduce((A,T)=>A+Ku(e,T),0);m+=w/4*u,i[s[3]+l*(t+1)+g+1]=m}o+=m,i[s[2]+l+1]=o}return{floats:i,places:s,total:o,width:t,height:n,up:Xu(e,t,n)}}var Ku=(r,e)=>.2126*r[3*e]+.7152*r[3*e+1]+.0722*r[3*e+2];function Xu(r,e,t){let n=[0,0,0];for(let s=0;s<t;s++){let i=Math.PI*(s+.5)/t,a=2*Math.PI**2*Math.sin(i)/(e*t)*Math.max(0,Math.cos(i));for(let o=0;o<3*e;o++)n[o%3]+=r[3*e*s+o]*a}return n}function Ju({rgb:r,width:e,height:t}){let n=Math.max(1,Math.ceil(e/Pa[0]),Math.ceil(t/Pa[1]));if(n===1)return{rgb:r,width:e,height:t};let s=Math.ceil(e/n),i=Math.ceil(t/n),a=new Float32Array(3*s*i);for(let o=0;o<i;o++)for(let l=0;l<s;l++){let u=0;for(let f=o*n;f<Math.min(t,(o+1)*n);f++)for(let p=l*n;p<Math.min(e,(l+1)*n);p++,u++)for(let m=0;m<3;m++)a[3*(o*s+l)+m]+=r[3*(f*e+p)+m];for(let f=0;f<3;f++)a[3*(o*s+l)+f]/=u}return{rgb:a,width:s,height:i}}function br(r){return{rgb:Float32Array.from({length:96},(n,s)=>r[s%3]),width:8,height:4}}function Ca(){let t=new Float32Array(24576),n=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let s=0;s<64;s++){let i=Math.PI*(s+.5)/64;for(let a=0;a<128;a++){let o=2*Math.PI*((a+.5)/128-.5),l=[Math.sin(i)*Math.sin(o),Math.cos(i),-Math.sin(i)*Math.cos(o)],u=.16+.14*Math.max(0,l[1]);for(let f=0;f<3;f++){let p=u*[.95,1,1.08][f];for(let[m,g,_]of n){let w=(l[0]*m[0]+l[1]*m[1]+l[2]*m[2])/Math.hypot(...m);p+=_[f]*Math.min(1,Math.max(0,(w-g)/.03))}t[3*(s*128+a)+f]=p}}}return{rgb:t,width:128,height:64}}function ct(r){let e=new TextDecoder().decode(r.subarray(0,512)).trimStart();return e.startsWith("version https://git-lfs.github.com/")?"a pointer of Git LFS, in whose place `git lfs pull` puts the file":/^<(!doctype\s+html|html|head|body)\b/i.test(e)?"an HTML page: there is no such file, or it has another address":null}var za={glTF:["glTF","glb"],BLENDER:["Blender","blend"]};function Ua(r){let e=new TextDecoder().decode(r.subarray(0,8)),t=Object.keys(za).find(i=>e.startsWith(i));if(!t)return null;let[n,s]=za[t];return`a ${n} file: rna-make makes a package of it, as rna-make model.${s} --out model.rna`}var Hs=0,Gs=1,$s=2,qs=3,js=4,Vs=5,Ws=6,Zs=7;var Ys=1006;var Qt=1015,en=1016;var ut=1023;var kn=1028;var tn=1030;var ft="srgb-linear";var Da=null;function Qu(r){let e=r[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=r[1];t&&t.isStackTrace?r[0]+=" "+t.getLocation():r[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return r}function Ba(...r){r=Qu(r);let e="THREE."+r.shift();if(Da)Da("warn",e,...r);else{let t=r[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...r)}}var jd={[Hs]:Hs,[$s]:Ws,[js]:js,[qs]:Vs,[Gs]:Gs,[Ws]:$s,[Zs]:Zs,[Vs]:qs};var Wd=Math.PI/180,Zd=180/Math.PI;function Ha(r,e,t){return Math.max(e,Math.min(t,r))}var Je=ef();function ef(){let r=new ArrayBuffer(4),e=new Float32Array(r),t=new Uint32Array(r),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){let u=l-127;u<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):u<-14?(n[l]=1024>>-u-14,n[l|256]=1024>>-u-14|32768,s[l]=-u-1,s[l|256]=-u-1):u<=15?(n[l]=u+15<<10,n[l|256]=u+15<<10|32768,s[l]=13,s[l|256]=13):u<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}let i=new Uint32Array(2048),a=new Uint32Array(64),o=new Uint32Array(64);for(let l=1;l<1024;++l){let u=l<<13,f=0;for(;(u&8388608)===0;)u<<=1,f-=8388608;u&=-8388609,f+=947912704,i[l]=u|f}for(let l=1024;l<2048;++l)i[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)a[l]=l<<23;a[31]=1199570944,a[32]=2147483648;for(let l=33;l<63;++l)a[l]=2147483648+(l-32<<23);a[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(o[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:s,mantissaTable:i,exponentTable:a,offsetTable:o}}function tf(r){Math.abs(r)>65504&&Ba("DataUtils.toHalfFloat(): Value out of range."),r=Ha(r,-65504,65504),Je.floatView[0]=r;let e=Je.uint32View[0],t=e>>23&511;return Je.baseTable[t]+((e&8388607)>>Je.shiftTable[t])}function nf(r){let e=r>>10;return Je.uint32View[0]=Je.mantissaTable[Je.offsetTable[e]+(r&1023)]+Je.exponentTable[e],Je.floatView[0]}var L=class{static toHalfFloat(e){return tf(e)}static fromHalfFloat(e){return nf(e)}};var xr=class{};var Se=Uint8Array,nn=Uint16Array,rf=Int32Array,Ga=new Se([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),$a=new Se([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),sf=new Se([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),qa=function(r,e){for(var t=new nn(31),n=0;n<31;++n)t[n]=e+=1<<r[n-1];for(var s=new rf(t[30]),n=1;n<30;++n)for(var i=t[n];i<t[n+1];++i)s[i]=i-t[n]<<5|n;return{b:t,r:s}},ja=qa(Ga,2),Va=ja.b,af=ja.r;Va[28]=258,af[258]=28;var Wa=qa($a,0),of=Wa.b,ng=Wa.r,Js=new nn(32768);for(K=0;K<32768;++K)Qe=(K&43690)>>1|(K&21845)<<1,Qe=(Qe&52428)>>2|(Qe&13107)<<2,Qe=(Qe&61680)>>4|(Qe&3855)<<4,Js[K]=((Qe&65280)>>8|(Qe&255)<<8)>>1;var Qe,K,Nn=(function(r,e,t){for(var n=r.length,s=0,i=new nn(e);s<n;++s)r[s]&&++i[r[s]-1];var a=new nn(e);for(s=1;s<e;++s)a[s]=a[s-1]+i[s-1]<<1;var o;if(t){o=new nn(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var u=s<<4|r[s],f=e-r[s],p=a[r[s]-1]++<<f,m=p|(1<<f)-1;p<=m;++p)o[Js[p]>>l]=u}else for(o=new nn(n),s=0;s<n;++s)r[s]&&(o[s]=Js[a[r[s]-1]++]>>15-r[s]);return o}),In=new Se(288);for(K=0;K<144;++K)In[K]=8;var K;for(K=144;K<256;++K)In[K]=9;var K;for(K=256;K<280;++K)In[K]=7;var K;for(K=280;K<288;++K)In[K]=8;var K,Za=new Se(32);for(K=0;K<32;++K)Za[K]=5;var K;var lf=Nn(In,9,1);var cf=Nn(Za,5,1),Ks=function(r){for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},Oe=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},Xs=function(r,e){var t=e/8|0;return(r[t]|r[t+1]<<8|r[t+2]<<16)>>(e&7)},uf=function(r){return(r+7)/8|0},ff=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new Se(r.subarray(e,t))};var hf=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Me=function(r,e,t){var n=new Error(e||hf[r]);if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,Me),!t)throw n;return n},pf=function(r,e,t,n){var s=r.length,i=n?n.length:0;if(!s||e.f&&!e.l)return t||new Se(0);var a=!t,o=a||e.i!=2,l=e.i;a&&(t=new Se(s*3));var u=function($n){var qn=t.length;if($n>qn){var gn=new Se(Math.max(qn*2,$n));gn.set(t),t=gn}},f=e.f||0,p=e.p||0,m=e.b||0,g=e.l,_=e.d,w=e.m,A=e.n,T=s*8;do{if(!g){f=Oe(r,p,1);var F=Oe(r,p+1,3);if(p+=3,F)if(F==1)g=lf,_=cf,w=9,A=5;else if(F==2){var we=Oe(r,p,31)+257,ne=Oe(r,p+10,15)+4,Gt=we+Oe(r,p+5,31)+1;p+=14;for(var Rt=new Se(Gt),qe=new Se(19),ce=0;ce<ne;++ce)qe[sf[ce]]=Oe(r,p+ce*3,7);p+=ne*3;for(var Bn=Ks(qe),us=(1<<Bn)-1,Ne=Nn(qe,Bn,1),ce=0;ce<Gt;){var dn=Ne[Oe(r,p,us)];p+=dn&15;var G=dn>>4;if(G<16)Rt[ce++]=G;else{var be=0,$t=0;for(G==16?($t=3+Oe(r,p,3),p+=2,be=Rt[ce-1]):G==17?($t=3+Oe(r,p,7),p+=3):G==18&&($t=11+Oe(r,p,127),p+=7);$t--;)Rt[ce++]=be}}var Hn=Rt.subarray(0,we),Ie=Rt.subarray(we);w=Ks(Hn),A=Ks(Ie),g=Nn(Hn,w,1),_=Nn(Ie,A,1)}else Me(1);else{var G=uf(p)+4,te=r[G-4]|r[G-3]<<8,le=G+te;if(le>s){l&&Me(0);break}o&&u(m+te),t.set(r.subarray(G,le),m),e.b=m+=te,e.p=p=le*8,e.f=f;continue}if(p>T){l&&Me(0);break}}o&&u(m+131072);for(var Gn=(1<<w)-1,fs=(1<<A)-1,xe=p;;xe=p){var be=g[Xs(r,p)&Gn],Fe=be>>4;if(p+=be&15,p>T){l&&Me(0);break}if(be||Me(2),Fe<256)t[m++]=Fe;else if(Fe==256){xe=p,g=null;break}else{var Te=Fe-254;if(Fe>264){var ce=Fe-257,je=Ga[ce];Te=Oe(r,p,(1<<je)-1)+Va[ce],p+=je}var St=_[Xs(r,p)&fs],qt=St>>4;St||Me(3),p+=St&15;var Ie=of[qt];if(qt>3){var je=$a[qt];Ie+=Xs(r,p)&(1<<je)-1,p+=je}if(p>T){l&&Me(0);break}o&&u(m+131072);var Q=m+Te;if(m<Ie){var Ve=i-Ie,nt=Math.min(Ie,Q);for(Ve+m<0&&Me(3);m<nt;++m)t[m]=n[Ve+m]}for(;m<Q;++m)t[m]=t[m-Ie]}}e.l=g,e.p=xe,e.b=m,e.f=f,g&&(f=1,e.m=w,e.d=_,e.n=A)}while(!f);return m!=t.length&&a?ff(t,0,m):t.subarray(0,m)};var mf=new Se(0);var df=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&Me(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&Me(6,"invalid zlib data: "+(r[1]&32?"need":"unexpected")+" dictionary"),(r[1]>>3&4)+2};function rn(r,e){return pf(r.subarray(df(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var gf=typeof TextDecoder<"u"&&new TextDecoder,_f=0;try{gf.decode(mf,{stream:!0}),_f=1}catch{}var Ar=class extends xr{constructor(e){super(e),this.type=en,this.outputFormat=ut,this.part=0}parse(e){let Rt=Math.pow(2.7182818,2.2),qe=null,ce=null;function Bn(c,h){let d=0;for(let x=0;x<65536;++x)(x==0||c[x>>3]&1<<(x&7))&&(h[d++]=x);let y=d-1;for(;d<65536;)h[d++]=0;return y}function us(c){for(let h=0;h<16384;h++)c[h]={},c[h].len=0,c[h].lit=0,c[h].p=null}let Ne={l:0,c:0,lc:0};function dn(c,h,d,y,x){for(;d<c;)h=h<<8|qi(y,x),d+=8;d-=c,Ne.l=h>>d&(1<<c)-1,Ne.c=h,Ne.lc=d}let be=new Array(59);function $t(c){for(let d=0;d<=58;++d)be[d]=0;for(let d=0;d<65537;++d)be[c[d]]+=1;let h=0;for(let d=58;d>0;--d){let y=h+be[d]>>1;be[d]=h,h=y}for(let d=0;d<65537;++d){let y=c[d];y>0&&(c[d]=y|be[y]++<<6)}}function Hn(c,h,d,y,x,R){let v=h,k=0,E=0;for(;y<=x;y++){if(v.value-h.value>d)return!1;dn(6,k,E,c,v);let S=Ne.l;if(k=Ne.c,E=Ne.lc,R[y]=S,S==63){if(v.value-h.value>d)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");dn(8,k,E,c,v);let N=Ne.l+6;if(k=Ne.c,E=Ne.lc,y+N>x+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;N--;)R[y++]=0;y--}else if(S>=59){let N=S-59+2;if(y+N>x+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;N--;)R[y++]=0;y--}}$t(R)}function Ie(c){return c&63}function Gn(c){return c>>6}function fs(c,h,d,y){for(;h<=d;h++){let x=Gn(c[h]),R=Ie(c[h]);if(x>>R)throw new Error("THREE.EXRLoader: Invalid table entry");if(R>14){let v=y[x>>R-14];if(v.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(v.lit++,v.p){let k=v.p;v.p=new Array(v.lit);for(let E=0;E<v.lit-1;++E)v.p[E]=k[E]}else v.p=new Array(1);v.p[v.lit-1]=h}else if(R){let v=0;for(let k=1<<14-R;k>0;k--){let E=y[(x<<14-R)+v];if(E.len||E.p)throw new Error("THREE.EXRLoader: Invalid table entry");E.len=R,E.lit=h,v++}}}return!0}let xe={c:0,lc:0};function Fe(c,h,d,y){c=c<<8|qi(d,y),h+=8,xe.c=c,xe.lc=h}let Te={c:0,lc:0};function je(c,h,d,y,x,R,v,k,E){if(c==h){y<8&&(Fe(d,y,x,R),d=xe.c,y=xe.lc),y-=8;let S=d>>y;if(S=new Uint8Array([S])[0],k.value+S>E)return!1;let N=v[k.value-1];for(;S-- >0;)v[k.value++]=N}else if(k.value<E)v[k.value++]=c;else return!1;Te.c=d,Te.lc=y}function St(c){return c&65535}function qt(c){let h=St(c);return h>32767?h-65536:h}let Q={a:0,b:0};function Ve(c,h){let d=qt(c),x=qt(h),R=d+(x&1)+(x>>1),v=R,k=R-x;Q.a=v,Q.b=k}function nt(c,h){let d=St(c),y=St(h),x=d-(y>>1)&65535,R=y+x-32768&65535;Q.a=R,Q.b=x}function $n(c,h,d,y,x,R,v){let k=v<16384,E=d>x?x:d,S=1,N,O;for(;S<=E;)S<<=1;for(S>>=1,N=S,S>>=1;S>=1;){O=0;let I=O+R*(x-N),P=R*S,z=R*N,M=y*S,C=y*N,H,V,q,Z;for(;O<=I;O+=z){let D=O,U=O+y*(d-N);for(;D<=U;D+=C){let B=D+M,J=D+P,Y=J+M;k?(Ve(c[D+h],c[J+h]),H=Q.a,q=Q.b,Ve(c[B+h],c[Y+h]),V=Q.a,Z=Q.b,Ve(H,V),c[D+h]=Q.a,c[B+h]=Q.b,Ve(q,Z),c[J+h]=Q.a,c[Y+h]=Q.b):(nt(c[D+h],c[J+h]),H=Q.a,q=Q.b,nt(c[B+h],c[Y+h]),V=Q.a,Z=Q.b,nt(H,V),c[D+h]=Q.a,c[B+h]=Q.b,nt(q,Z),c[J+h]=Q.a,c[Y+h]=Q.b)}if(d&S){let B=D+P;k?Ve(c[D+h],c[B+h]):nt(c[D+h],c[B+h]),H=Q.a,c[B+h]=Q.b,c[D+h]=H}}if(x&S){let D=O,U=O+y*(d-N);for(;D<=U;D+=C){let B=D+M;k?Ve(c[D+h],c[B+h]):nt(c[D+h],c[B+h]),H=Q.a,c[B+h]=Q.b,c[D+h]=H}}N=S,S>>=1}return O}function qn(c,h,d,y,x,R,v,k,E){let S=0,N=0,O=v,I=Math.trunc(y.value+(x+7)/8);for(;y.value<I;)for(Fe(S,N,d,y),S=xe.c,N=xe.lc;N>=14;){let z=S>>N-14&16383,M=h[z];if(M.len)N-=M.len,je(M.lit,R,S,N,d,y,k,E,O),S=Te.c,N=Te.lc;else{if(!M.p)throw new Error("THREE.EXRLoader: hufDecode issues");let C;for(C=0;C<M.lit;C++){let H=Ie(c[M.p[C]]);for(;N<H&&y.value<I;)Fe(S,N,d,y),S=xe.c,N=xe.lc;if(N>=H&&Gn(c[M.p[C]])==(S>>N-H&(1<<H)-1)){N-=H,je(M.p[C],R,S,N,d,y,k,E,O),S=Te.c,N=Te.lc;break}}if(C==M.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let P=8-x&7;for(S>>=P,N-=P;N>0;){let z=h[S<<14-N&16383];if(z.len)N-=z.len,je(z.lit,R,S,N,d,y,k,E,O),S=Te.c,N=Te.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function gn(c,h,d,y,x,R){let v={value:0},k=d.value,E=ve(h,d),S=ve(h,d);d.value+=4;let N=ve(h,d);if(d.value+=4,E<0||E>=65537||S<0||S>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let O=new Array(65537),I=new Array(16384);us(I);let P=y-(d.value-k);if(Hn(c,d,P,E,S,O),N>8*(y-(d.value-k)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");fs(O,E,S,I),qn(O,I,c,d,N,S,R,x,v)}function pc(c,h,d){for(let y=0;y<d;++y)h[y]=c[h[y]]}function jn(c){for(let h=1;h<c.length;h++){let d=c[h-1]+c[h]-128;c[h]=d}}function Vn(c,h){let d=0,y=Math.floor((c.length+1)/2),x=0,R=c.length-1;for(;!(x>R||(h[x++]=c[d++],x>R));)h[x++]=c[y++]}function hs(c){let h=c.byteLength,d=new Array,y=0,x=new DataView(c);for(;h>0;){let R=x.getInt8(y++);if(R<0){let v=-R;h-=v+1;for(let k=0;k<v;k++)d.push(x.getUint8(y++))}else{let v=R;h-=2;let k=x.getUint8(y++);for(let E=0;E<v+1;E++)d.push(k)}}return d}function mc(c,h,d,y,x,R){let v=new DataView(R.buffer),k=d[c.idx[0]].width,E=d[c.idx[0]].height,S=3,N=Math.floor(k/8),O=Math.ceil(k/8),I=Math.ceil(E/8),P=k-(O-1)*8,z=E-(I-1)*8,M={value:0},C=new Array(S),H=new Array(S),V=new Array(S),q=new Array(S),Z=new Array(S);for(let U=0;U<S;++U)Z[U]=h[c.idx[U]],C[U]=U<1?0:C[U-1]+O*I,H[U]=new Float32Array(64),V[U]=new Uint16Array(64),q[U]=new Uint16Array(O*64);for(let U=0;U<I;++U){let B=8;U==I-1&&(B=z);let J=8;for(let j=0;j<O;++j){j==O-1&&(J=P);for(let W=0;W<S;++W)V[W].fill(0),V[W][0]=x[C[W]++],zi(M,y,V[W]),Ui(V[W],H[W]),Di(H[W]);S==3&&gc(H);for(let W=0;W<S;++W)Gi(H[W],q[W],j*64)}let Y=0;for(let j=0;j<S;++j){let W=d[c.idx[j]].type;for(let re=8*U;re<8*U+B;++re){Y=Z[j][re];for(let ye=0;ye<N;++ye){let ee=ye*64+(re&7)*8;v.setUint16(Y+0*W,q[j][ee+0],!0),v.setUint16(Y+2*W,q[j][ee+1],!0),v.setUint16(Y+4*W,q[j][ee+2],!0),v.setUint16(Y+6*W,q[j][ee+3],!0),v.setUint16(Y+8*W,q[j][ee+4],!0),v.setUint16(Y+10*W,q[j][ee+5],!0),v.setUint16(Y+12*W,q[j][ee+6],!0),v.setUint16(Y+14*W,q[j][ee+7],!0),Y+=16*W}}if(N!=O)for(let re=8*U;re<8*U+B;++re){let ye=Z[j][re]+8*N*2*W,ee=N*64+(re&7)*8;for(let Ce=0;Ce<J;++Ce)v.setUint16(ye+Ce*2*W,q[j][ee+Ce],!0)}}}let D=new Uint16Array(k);v=new DataView(R.buffer);for(let U=0;U<S;++U){d[c.idx[U]].decoded=!0;let B=d[c.idx[U]].type;if(d[U].type==2)for(let J=0;J<E;++J){let Y=Z[U][J];for(let j=0;j<k;++j)D[j]=v.getUint16(Y+j*2*B,!0);for(let j=0;j<k;++j)v.setFloat32(Y+j*2*B,L.fromHalfFloat(D[j]),!0)}}}function dc(c,h,d,y,x,R){let v=new DataView(R.buffer),k=d[c],E=k.width,S=k.height,N=Math.ceil(E/8),O=Math.ceil(S/8),I=Math.floor(E/8),P=E-(N-1)*8,z=S-(O-1)*8,M={value:0},C=0,H=new Float32Array(64),V=new Uint16Array(64),q=new Uint16Array(N*64);for(let Z=0;Z<O;++Z){let D=8;Z==O-1&&(D=z);for(let U=0;U<N;++U)V.fill(0),V[0]=x[C++],zi(M,y,V),Ui(V,H),Di(H),Gi(H,q,U*64);for(let U=8*Z;U<8*Z+D;++U){let B=h[c][U];for(let J=0;J<I;++J){let Y=J*64+(U&7)*8;for(let j=0;j<8;++j)v.setUint16(B+j*2*k.type,q[Y+j],!0);B+=16*k.type}if(N!=I){let J=I*64+(U&7)*8;for(let Y=0;Y<P;++Y)v.setUint16(B+Y*2*k.type,q[J+Y],!0)}}}k.decoded=!0}function zi(c,h,d){let y,x=1;for(;x<64;)y=h[c.value],y==65280?x=64:y>>8==255?x+=y&255:(d[x]=y,x++),c.value++}function Ui(c,h){h[0]=L.fromHalfFloat(c[0]),h[1]=L.fromHalfFloat(c[1]),h[2]=L.fromHalfFloat(c[5]),h[3]=L.fromHalfFloat(c[6]),h[4]=L.fromHalfFloat(c[14]),h[5]=L.fromHalfFloat(c[15]),h[6]=L.fromHalfFloat(c[27]),h[7]=L.fromHalfFloat(c[28]),h[8]=L.fromHalfFloat(c[2]),h[9]=L.fromHalfFloat(c[4]),h[10]=L.fromHalfFloat(c[7]),h[11]=L.fromHalfFloat(c[13]),h[12]=L.fromHalfFloat(c[16]),h[13]=L.fromHalfFloat(c[26]),h[14]=L.fromHalfFloat(c[29]),h[15]=L.fromHalfFloat(c[42]),h[16]=L.fromHalfFloat(c[3]),h[17]=L.fromHalfFloat(c[8]),h[18]=L.fromHalfFloat(c[12]),h[19]=L.fromHalfFloat(c[17]),h[20]=L.fromHalfFloat(c[25]),h[21]=L.fromHalfFloat(c[30]),h[22]=L.fromHalfFloat(c[41]),h[23]=L.fromHalfFloat(c[43]),h[24]=L.fromHalfFloat(c[9]),h[25]=L.fromHalfFloat(c[11]),h[26]=L.fromHalfFloat(c[18]),h[27]=L.fromHalfFloat(c[24]),h[28]=L.fromHalfFloat(c[31]),h[29]=L.fromHalfFloat(c[40]),h[30]=L.fromHalfFloat(c[44]),h[31]=L.fromHalfFloat(c[53]),h[32]=L.fromHalfFloat(c[10]),h[33]=L.fromHalfFloat(c[19]),h[34]=L.fromHalfFloat(c[23]),h[35]=L.fromHalfFloat(c[32]),h[36]=L.fromHalfFloat(c[39]),h[37]=L.fromHalfFloat(c[45]),h[38]=L.fromHalfFloat(c[52]),h[39]=L.fromHalfFloat(c[54]),h[40]=L.fromHalfFloat(c[20]),h[41]=L.fromHalfFloat(c[22]),h[42]=L.fromHalfFloat(c[33]),h[43]=L.fromHalfFloat(c[38]),h[44]=L.fromHalfFloat(c[46]),h[45]=L.fromHalfFloat(c[51]),h[46]=L.fromHalfFloat(c[55]),h[47]=L.fromHalfFloat(c[60]),h[48]=L.fromHalfFloat(c[21]),h[49]=L.fromHalfFloat(c[34]),h[50]=L.fromHalfFloat(c[37]),h[51]=L.fromHalfFloat(c[47]),h[52]=L.fromHalfFloat(c[50]),h[53]=L.fromHalfFloat(c[56]),h[54]=L.fromHalfFloat(c[59]),h[55]=L.fromHalfFloat(c[61]),h[56]=L.fromHalfFloat(c[35]),h[57]=L.fromHalfFloat(c[36]),h[58]=L.fromHalfFloat(c[48]),h[59]=L.fromHalfFloat(c[49]),h[60]=L.fromHalfFloat(c[57]),h[61]=L.fromHalfFloat(c[58]),h[62]=L.fromHalfFloat(c[62]),h[63]=L.fromHalfFloat(c[63])}function Di(c){let h=.5*Math.cos(.7853975),d=.5*Math.cos(3.14159/16),y=.5*Math.cos(3.14159/8),x=.5*Math.cos(3*3.14159/16),R=.5*Math.cos(5*3.14159/16),v=.5*Math.cos(3*3.14159/8),k=.5*Math.cos(7*3.14159/16),E=new Array(4),S=new Array(4),N=new Array(4),O=new Array(4);for(let I=0;I<8;++I){let P=I*8;E[0]=y*c[P+2],E[1]=v*c[P+2],E[2]=y*c[P+6],E[3]=v*c[P+6],S[0]=d*c[P+1]+x*c[P+3]+R*c[P+5]+k*c[P+7],S[1]=x*c[P+1]-k*c[P+3]-d*c[P+5]-R*c[P+7],S[2]=R*c[P+1]-d*c[P+3]+k*c[P+5]+x*c[P+7],S[3]=k*c[P+1]-R*c[P+3]+x*c[P+5]-d*c[P+7],N[0]=h*(c[P+0]+c[P+4]),N[3]=h*(c[P+0]-c[P+4]),N[1]=E[0]+E[3],N[2]=E[1]-E[2],O[0]=N[0]+N[1],O[1]=N[3]+N[2],O[2]=N[3]-N[2],O[3]=N[0]-N[1],c[P+0]=O[0]+S[0],c[P+1]=O[1]+S[1],c[P+2]=O[2]+S[2],c[P+3]=O[3]+S[3],c[P+4]=O[3]-S[3],c[P+5]=O[2]-S[2],c[P+6]=O[1]-S[1],c[P+7]=O[0]-S[0]}for(let I=0;I<8;++I)E[0]=y*c[16+I],E[1]=v*c[16+I],E[2]=y*c[48+I],E[3]=v*c[48+I],S[0]=d*c[8+I]+x*c[24+I]+R*c[40+I]+k*c[56+I],S[1]=x*c[8+I]-k*c[24+I]-d*c[40+I]-R*c[56+I],S[2]=R*c[8+I]-d*c[24+I]+k*c[40+I]+x*c[56+I],S[3]=k*c[8+I]-R*c[24+I]+x*c[40+I]-d*c[56+I],N[0]=h*(c[I]+c[32+I]),N[3]=h*(c[I]-c[32+I]),N[1]=E[0]+E[3],N[2]=E[1]-E[2],O[0]=N[0]+N[1],O[1]=N[3]+N[2],O[2]=N[3]-N[2],O[3]=N[0]-N[1],c[0+I]=O[0]+S[0],c[8+I]=O[1]+S[1],c[16+I]=O[2]+S[2],c[24+I]=O[3]+S[3],c[32+I]=O[3]-S[3],c[40+I]=O[2]-S[2],c[48+I]=O[1]-S[1],c[56+I]=O[0]-S[0]}function gc(c){for(let h=0;h<64;++h){let d=c[0][h],y=c[1][h],x=c[2][h];c[0][h]=d+1.5747*x,c[1][h]=d-.1873*y-.4682*x,c[2][h]=d+1.8556*y}}let ps=new Float32Array(1),Bi=new Uint32Array(ps.buffer);function Hi(c){ps[0]=c;let h=Bi[0],d=h>>>16&32768,y=h&2147483647;if(y>=1199570944)return d|(y>2139095040?32256:31744);if(y<947912704)return ps[0]=Math.abs(c)+.5,d|Bi[0]-1056964608;let x=y+4095+(y>>>13&1);return d|x-939524096>>>13}function Gi(c,h,d){if(ce===null){ce=new Uint16Array(65536);for(let y=1;y<65536;++y){if((y&31744)===31744)continue;let x=L.fromHalfFloat(y),R=Math.abs(x),v=R<=1?Math.pow(R,2.2):Math.pow(Rt,R-1);ce[y]=Hi(x<0?-v:v)}}for(let y=0;y<64;++y)h[d+y]=ce[Hi(c[y])]}function Wn(c){return new DataView(c.array.buffer,c.offset.value,c.size)}function _c(c){let h=c.viewer.buffer.slice(c.offset.value,c.offset.value+c.size),d=new Uint8Array(hs(h)),y=new Uint8Array(d.length);return jn(d),Vn(d,y),new DataView(y.buffer)}function ms(c){let h=c.array.slice(c.offset.value,c.offset.value+c.size),d=rn(h),y=new Uint8Array(d.length);return jn(d),Vn(d,y),new DataView(y.buffer)}function vc(c){let h=c.viewer,d={value:c.offset.value},y=new Uint16Array(c.columns*c.lines*(c.inputChannels.length*c.type)),x=new Uint8Array(8192),R=0,v=new Array(c.inputChannels.length);for(let z=0,M=c.inputChannels.length;z<M;z++)v[z]={},v[z].start=R,v[z].end=v[z].start,v[z].nx=c.columns,v[z].ny=c.lines,v[z].size=c.type,R+=v[z].nx*v[z].ny*v[z].size;let k=_n(h,d),E=_n(h,d);if(E>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(k<=E)for(let z=0;z<E-k+1;z++)x[z+k]=rt(h,d);let S=new Uint16Array(65536),N=Bn(x,S),O=ve(h,d);gn(c.array,h,d,O,y,R);for(let z=0;z<c.inputChannels.length;++z){let M=v[z];for(let C=0;C<v[z].size;++C)$n(y,M.start+C,M.nx,M.size,M.ny,M.nx*M.size,N)}pc(S,y,R);let I=0,P=new Uint8Array(y.buffer.byteLength);for(let z=0;z<c.lines;z++)for(let M=0;M<c.inputChannels.length;M++){let C=v[M],H=C.nx*C.size,V=new Uint8Array(y.buffer,C.end*2,H*2);P.set(V,I),I+=H*2,C.end+=H}return new DataView(P.buffer)}function yc(c){let h=c.array.slice(c.offset.value,c.offset.value+c.size),d=rn(h),y=c.inputChannels.length*c.lines*c.columns*c.totalBytes,x=new ArrayBuffer(y),R=new DataView(x),v=0,k=0,E=new Array(4);for(let S=0;S<c.lines;S++)for(let N=0;N<c.inputChannels.length;N++){let O=0;switch(c.inputChannels[N].pixelType){case 1:E[0]=v,E[1]=E[0]+c.columns,v=E[1]+c.columns;for(let P=0;P<c.columns;++P){let z=d[E[0]++]<<8|d[E[1]++];O+=z,R.setUint16(k,O,!0),k+=2}break;case 2:E[0]=v,E[1]=E[0]+c.columns,E[2]=E[1]+c.columns,v=E[2]+c.columns;for(let P=0;P<c.columns;++P){let z=d[E[0]++]<<24|d[E[1]++]<<16|d[E[2]++]<<8;O+=z,R.setUint32(k,O,!0),k+=4}break}}return R}function wc(c){let h=c.array,d=c.offset.value,y=c.columns,x=c.lines,R=c.inputChannels,v=c.totalBytes,k=he.compression==="B44A_COMPRESSION",E=new Uint8Array(x*y*v),S=new Uint16Array(16),N=0;for(let O=0;O<R.length;O++){let I=R[O],P=I.pixelType*2,z=Math.ceil(y/I.xSampling),M=Math.ceil(x/I.ySampling),C=I.xSampling===1&&I.ySampling===1;if(I.pixelType!==1){for(let q=0;q<M;q++)if(C){let Z=q*y*v+N*y;for(let D=0;D<z*P;D++)E[Z+D]=h[d++]}else d+=z*P;N+=P;continue}let H=Math.ceil(z/4),V=Math.ceil(M/4);for(let q=0;q<V;q++)for(let Z=0;Z<H;Z++){if(k&&h[d+2]>=52){let D=h[d]<<8|h[d+1],U=D&32768?D&32767:~D&65535;S.fill(U),d+=3}else{let D=h[d]<<8|h[d+1],U=h[d+2]>>2,B=32<<U,J=D+((h[d+2]<<4|h[d+3]>>4)&63)*(1<<U)-B&65535,Y=J+((h[d+3]<<2|h[d+4]>>6)&63)*(1<<U)-B&65535,j=Y+(h[d+4]&63)*(1<<U)-B&65535,W=D+(h[d+5]>>2&63)*(1<<U)-B&65535,re=J+((h[d+5]<<4|h[d+6]>>4)&63)*(1<<U)-B&65535,ye=Y+((h[d+6]<<2|h[d+7]>>6)&63)*(1<<U)-B&65535,ee=j+(h[d+7]&63)*(1<<U)-B&65535,Ce=W+(h[d+8]>>2&63)*(1<<U)-B&65535,jt=re+((h[d+8]<<4|h[d+9]>>4)&63)*(1<<U)-B&65535,vn=ye+((h[d+9]<<2|h[d+10]>>6)&63)*(1<<U)-B&65535,ze=ee+(h[d+10]&63)*(1<<U)-B&65535,kt=Ce+(h[d+11]>>2&63)*(1<<U)-B&65535,Jn=jt+((h[d+11]<<4|h[d+12]>>4)&63)*(1<<U)-B&65535,Qn=vn+((h[d+12]<<2|h[d+13]>>6)&63)*(1<<U)-B&65535,er=ze+(h[d+13]&63)*(1<<U)-B&65535,yn=[D,W,Ce,kt,J,re,jt,Jn,Y,ye,vn,Qn,j,ee,ze,er];for(let Vt=0;Vt<16;Vt++)S[Vt]=yn[Vt]&32768?yn[Vt]&32767:~yn[Vt]&65535;d+=14}if(I.pLinear){if(qe===null){qe=new Uint16Array(65536);for(let D=0;D<65536;D++)if((D&31744)===31744||D>32768)qe[D]=0;else{let U=L.fromHalfFloat(D);qe[D]=U<=0?0:L.toHalfFloat(8*Math.log(U))}}for(let D=0;D<16;D++)S[D]=qe[S[D]]}for(let D=0;D<4;D++){let U=q*4+D;if(!(U>=M))for(let B=0;B<4;B++){let J=Z*4+B;if(J>=z)continue;let Y=S[D*4+B];for(let j=0;j<I.ySampling;j++){let W=U*I.ySampling+j;if(!(W>=x))for(let re=0;re<I.xSampling;re++){let ye=J*I.xSampling+re;if(ye>=y)continue;let ee=W*y*v+N*y+ye*2;E[ee]=Y&255,E[ee+1]=Y>>8&255}}}}}N+=2}return new DataView(E.buffer)}function $i(c){let h=c.viewer,d={value:c.offset.value},y=new Uint8Array(c.columns*c.lines*(c.inputChannels.length*c.type*2)),x={version:ae(h,d),unknownUncompressedSize:ae(h,d),unknownCompressedSize:ae(h,d),acCompressedSize:ae(h,d),dcCompressedSize:ae(h,d),rleCompressedSize:ae(h,d),rleUncompressedSize:ae(h,d),rleRawSize:ae(h,d),totalAcUncompressedCount:ae(h,d),totalDcUncompressedCount:ae(h,d),acCompression:ae(h,d)};if(x.version<2)throw new Error("THREE.EXRLoader: "+he.compression+" version "+x.version+" is unsupported");let R=new Array,v=_n(h,d)-2;for(;v>0;){let M=Zn(h.buffer,d),C=rt(h,d),H=C>>2&3,V=(C>>4)-1,q=new Int8Array([V])[0],Z=rt(h,d);R.push({name:M,index:q,type:Z,compression:H}),v-=M.length+3}let k=he.channels,E=new Array(c.inputChannels.length);for(let M=0;M<c.inputChannels.length;++M){let C=E[M]={},H=k[M];C.name=H.name,C.compression=0,C.decoded=!1,C.type=H.pixelType,C.pLinear=H.pLinear,C.width=c.columns,C.height=c.lines}let S={idx:new Array(3)};for(let M=0;M<c.inputChannels.length;++M){let C=E[M],H=C.name.lastIndexOf("."),V=H>=0?C.name.substring(H+1):C.name;for(let q=0;q<R.length;++q){let Z=R[q];V===Z.name&&C.type===Z.type&&(C.compression=Z.compression,Z.index>=0&&(S.idx[Z.index]=M),C.offset=M)}}let N,O,I;if(x.acCompressedSize>0)switch(x.acCompression){case 0:N=new Uint16Array(x.totalAcUncompressedCount),gn(c.array,h,d,x.acCompressedSize,N,x.totalAcUncompressedCount);break;case 1:let M=c.array.slice(d.value,d.value+x.totalAcUncompressedCount),C=rn(M);N=new Uint16Array(C.buffer),d.value+=x.totalAcUncompressedCount;break}if(x.dcCompressedSize>0){let M={array:c.array,offset:d,size:x.dcCompressedSize};O=new Uint16Array(ms(M).buffer),d.value+=x.dcCompressedSize}if(x.rleRawSize>0){let M=c.array.slice(d.value,d.value+x.rleCompressedSize),C=rn(M);I=hs(C.buffer),d.value+=x.rleCompressedSize}let P=0,z=new Array(E.length);for(let M=0;M<z.length;++M)z[M]=new Array;for(let M=0;M<c.lines;++M)for(let C=0;C<E.length;++C)z[C].push(P),P+=E[C].width*c.type*2;S.idx[0]!==void 0&&E[S.idx[0]]&&mc(S,z,E,N,O,y);for(let M=0;M<E.length;++M){let C=E[M];if(!C.decoded)switch(C.compression){case 2:let H=0,V=0;for(let q=0;q<c.lines;++q){let Z=z[M][H];for(let D=0;D<C.width;++D){for(let U=0;U<2*C.type;++U)y[Z++]=I[V+U*C.width*C.height];V++}H++}break;case 1:dc(M,z,E,N,O,y);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(y.buffer)}function Zn(c,h){let d=new Uint8Array(c),y=0;for(;d[h.value+y]!=0;)y+=1;let x=new TextDecoder().decode(d.slice(h.value,h.value+y));return h.value=h.value+y+1,x}function bc(c,h,d){let y=new TextDecoder().decode(new Uint8Array(c).slice(h.value,h.value+d));return h.value=h.value+d,y}function xc(c,h){let d=_e(c,h),y=ve(c,h);return[d,y]}function Ac(c,h){let d=ve(c,h),y=ve(c,h);return[d,y]}function _e(c,h){let d=c.getInt32(h.value,!0);return h.value=h.value+4,d}function ve(c,h){let d=c.getUint32(h.value,!0);return h.value=h.value+4,d}function qi(c,h){let d=c[h.value];return h.value=h.value+1,d}function rt(c,h){let d=c.getUint8(h.value);return h.value=h.value+1,d}let ae=function(c,h){let d=Number(c.getBigInt64(h.value,!0));return h.value+=8,d};function fe(c,h){let d=c.getFloat32(h.value,!0);return h.value+=4,d}function Ec(c,h){return L.toHalfFloat(fe(c,h))}function _n(c,h){let d=c.getUint16(h.value,!0);return h.value+=2,d}function Rc(c,h){return L.fromHalfFloat(_n(c,h))}function Sc(c,h,d,y){let x=d.value,R=[];for(;d.value<x+y-1;){let v=Zn(h,d),k=_e(c,d),E=rt(c,d);d.value+=3;let S=_e(c,d),N=_e(c,d);R.push({name:v,pixelType:k,pLinear:E,xSampling:S,ySampling:N})}return d.value+=1,R}function kc(c,h){let d=fe(c,h),y=fe(c,h),x=fe(c,h),R=fe(c,h),v=fe(c,h),k=fe(c,h),E=fe(c,h),S=fe(c,h);return{redX:d,redY:y,greenX:x,greenY:R,blueX:v,blueY:k,whiteX:E,whiteY:S}}function Nc(c,h){let d=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],y=rt(c,h);return d[y]}function Ic(c,h){let d=_e(c,h),y=_e(c,h),x=_e(c,h),R=_e(c,h);return{xMin:d,yMin:y,xMax:x,yMax:R}}function Tc(c,h){let d=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],y=rt(c,h);return d[y]}function Oc(c,h){let d=["ENVMAP_LATLONG","ENVMAP_CUBE"],y=rt(c,h);return d[y]}function Mc(c,h){let d=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],y=["ROUND_DOWN","ROUND_UP"],x=ve(c,h),R=ve(c,h),v=rt(c,h);return{xSize:x,ySize:R,levelMode:d[v&15],roundingMode:y[v>>4]}}function Lc(c,h){let d=fe(c,h),y=fe(c,h);return[d,y]}function Pc(c,h){let d=fe(c,h),y=fe(c,h),x=fe(c,h);return[d,y,x]}function Fc(c,h,d,y,x){if(y==="string"||y==="stringvector"||y==="iccProfile")return bc(h,d,x);if(y==="chlist")return Sc(c,h,d,x);if(y==="chromaticities")return kc(c,d);if(y==="compression")return Nc(c,d);if(y==="box2i")return Ic(c,d);if(y==="envmap")return Oc(c,d);if(y==="tiledesc")return Mc(c,d);if(y==="lineOrder")return Tc(c,d);if(y==="float")return fe(c,d);if(y==="v2f")return Lc(c,d);if(y==="v3f")return Pc(c,d);if(y==="int")return _e(c,d);if(y==="rational")return xc(c,d);if(y==="timecode")return Ac(c,d);if(y==="preview"||y==="deepImageState"||y==="idmanifest")return d.value+=x,"skipped";d.value+=x}function Cc(c,h){let d=Math.log2(c);return h=="ROUND_DOWN"?Math.floor(d):Math.ceil(d)}function zc(c,h,d){let y=0;switch(c.levelMode){case"ONE_LEVEL":y=1;break;case"MIPMAP_LEVELS":y=Cc(Math.max(h,d),c.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return y}function ji(c,h,d,y){let x=new Array(c);for(let R=0;R<c;R++){let v=1<<R,k=h/v|0;y=="ROUND_UP"&&k*v<h&&(k+=1);let E=Math.max(k,1);x[R]=(E+d-1)/d|0}return x}function Uc(){let c=this,h=c.offset,d={value:0};for(let y=0;y<c.tileCount;y++){let x=_e(c.viewer,h),R=_e(c.viewer,h);h.value+=8,c.size=ve(c.viewer,h);let v=x*c.blockWidth,k=R*c.blockHeight;c.columns=v+c.blockWidth>c.width?c.width-v:c.blockWidth,c.lines=k+c.blockHeight>c.height?c.height-k:c.blockHeight;let E=c.columns*c.totalBytes,N=c.size<c.lines*E?c.uncompress(c):Wn(c);h.value+=c.size;for(let O=0;O<c.lines;O++){let I=O*c.columns*c.totalBytes;for(let P=0;P<c.inputChannels.length;P++){let z=he.channels[P].name,M=c.channelByteOffsets[z]*c.columns,C=c.decodeChannels[z];if(C===void 0)continue;d.value=I+M;let H=(c.height-(1+k+O))*c.outLineWidth;for(let V=0;V<c.columns;V++){let q=H+(V+v)*c.outputChannels+C;c.byteArray[q]=c.getter(N,d)}}}}}function Dc(){let c=this,h=c.offset,d={value:0};for(let y=0;y<c.height/c.blockHeight;y++){let x=_e(c.viewer,h)-he.dataWindow.yMin;c.size=ve(c.viewer,h),c.lines=x+c.blockHeight>c.height?c.height-x:c.blockHeight;let R=c.columns*c.totalBytes,k=c.size<c.lines*R?c.uncompress(c):Wn(c);h.value+=c.size;for(let E=0;E<c.lines;E++){let S=x+E,N=E*R,O=(c.height-1-S)*c.outLineWidth;for(let I=0;I<c.inputChannels.length;I++){let P=he.channels[I].name,z=c.channelByteOffsets[P]*c.columns,M=c.decodeChannels[P];if(M!==void 0){d.value=N+z;for(let C=0;C<c.columns;C++){let H=O+C*c.outputChannels+M;c.byteArray[H]=c.getter(k,d)}}}}}}function Bc(){let c=this,h=c.chunkOffsets,d={value:0};for(let y=0;y<h.length;y++){let x={value:h[y]};x.value+=4;let R=_e(c.viewer,x)-he.dataWindow.yMin;c.size=ve(c.viewer,x),c.lines=R+c.blockHeight>c.height?c.height-R:c.blockHeight;let v=c.columns*c.totalBytes,k=c.size<c.lines*v,E=c.offset;c.offset=x;let S=k?c.uncompress(c):Wn(c);c.offset=E;for(let N=0;N<c.lines;N++){let O=R+N,I=N*v,P=(c.height-1-O)*c.outLineWidth;for(let z=0;z<c.inputChannels.length;z++){let M=he.channels[z].name,C=c.channelByteOffsets[M]*c.columns,H=c.decodeChannels[M];if(H!==void 0){d.value=I+C;for(let V=0;V<c.columns;V++){let q=P+V*c.outputChannels+H;c.byteArray[q]=c.getter(S,d)}}}}}}function Vi(c,h,d,y){if(d===0)return null;let x=c.slice(h,h+d);switch(y){case"NO_COMPRESSION":return new DataView(x.buffer,x.byteOffset,x.byteLength);case"RLE_COMPRESSION":{let R=new Uint8Array(hs(x.buffer.slice(x.byteOffset,x.byteOffset+x.byteLength))),v=new Uint8Array(R.length);return jn(R),Vn(R,v),new DataView(v.buffer)}case"ZIPS_COMPRESSION":{let R=rn(x),v=new Uint8Array(R.length);return jn(R),Vn(R,v),new DataView(v.buffer)}default:throw new Error("THREE.EXRLoader: "+y+" is unsupported for deep data")}}function Hc(){let c=this,h=c.chunkOffsets,d=c.width,y=c.height,x=c.deepChannels,R=he.compression,v=c.multiPart,k=c.decodeChannels,E=c.outputChannels,S=c.byteArray instanceof Uint16Array,N=-1;for(let O=0;O<x.length;O++)if(x[O].name==="A"){N=O;break}for(let O=0;O<h.length;O++){let I={value:h[O]};v&&(I.value+=4);let P=_e(c.viewer,I)-he.dataWindow.yMin,z=ae(c.viewer,I),M=ae(c.viewer,I);ae(c.viewer,I);let C=Vi(c.array,I.value,z,R);if(I.value+=z,C===null)continue;let H=new Uint32Array(d);for(let B=0;B<d;B++)H[B]=C.getUint32(B*4,!0);let V=H[d-1];if(V===0){I.value+=M;continue}let q=Vi(c.array,I.value,M,R),Z=[],D=0;for(let B=0;B<x.length;B++)Z.push(D),D+=V*x[B].bytesPerSample;let U=(y-1-P)*c.outLineWidth;for(let B=0;B<d;B++){let J=B===0?0:H[B-1],j=H[B]-J;if(j===0)continue;let W=new Float32Array(E),re=0;for(let ee=0;ee<j;ee++){let Ce=J+ee,jt=1-re;if(jt<=0)break;let vn=1;if(N>=0){let ze=x[N].bytesPerSample,kt=Z[N]+Ce*ze;vn=ze===2?L.fromHalfFloat(q.getUint16(kt,!0)):q.getFloat32(kt,!0)}for(let ze=0;ze<x.length;ze++){let kt=x[ze],Jn=k[kt.name];if(Jn===void 0)continue;let Qn=kt.bytesPerSample,er=Z[ze]+Ce*Qn,yn=Qn===2?L.fromHalfFloat(q.getUint16(er,!0)):q.getFloat32(er,!0);W[Jn]+=yn*jt}re+=vn*jt}k.A!==void 0&&(W[k.A]=re);let ye=U+B*E;for(let ee=0;ee<E;ee++)c.byteArray[ye+ee]=S?L.toHalfFloat(W[ee]):W[ee]}}}function Wi(c,h,d){let y={},x=!1;for(;;){let R=Zn(h,d);if(R==="")break;x=!0;let v=Zn(h,d),k=ve(c,d),E=Fc(c,h,d,v,k);E===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${v}'.`):y[R]=E}return x?y:null}function Gc(c,h,d){if(c.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let y=c.getUint8(4),x=c.getUint8(5),R={singleTile:!!(x&2),longName:!!(x&4),deepFormat:!!(x&8),multiPart:!!(x&16)};d.value=8;let v=[];if(R.multiPart){for(;;){let k=Wi(c,h,d);if(k===null)break;k.version=y,k.spec=R,v.push(k)}if(v.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let k=Wi(c,h,d);k.version=y,k.spec=R,v.push(k)}return v}function $c(c,h,d,y,x,R){let v={size:0,viewer:h,array:d,offset:y,width:c.dataWindow.xMax-c.dataWindow.xMin+1,height:c.dataWindow.yMax-c.dataWindow.yMin+1,inputChannels:c.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:ft};switch(c.compression){case"NO_COMPRESSION":v.blockHeight=1,v.uncompress=Wn;break;case"RLE_COMPRESSION":v.blockHeight=1,v.uncompress=_c;break;case"ZIPS_COMPRESSION":v.blockHeight=1,v.uncompress=ms;break;case"ZIP_COMPRESSION":v.blockHeight=16,v.uncompress=ms;break;case"PIZ_COMPRESSION":v.blockHeight=32,v.uncompress=vc;break;case"PXR24_COMPRESSION":v.blockHeight=16,v.uncompress=yc;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":v.blockHeight=32,v.uncompress=wc;break;case"DWAA_COMPRESSION":v.blockHeight=32,v.uncompress=$i;break;case"DWAB_COMPRESSION":v.blockHeight=256,v.uncompress=$i;break;default:throw new Error("THREE.EXRLoader: "+c.compression+" is unsupported")}let k={};for(let I of c.channels)switch(I.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":k[I.name]=!0,v.type=I.pixelType}let E=!1,S=!1;if(k.Y&&k.RY&&k.BY)v.outputChannels=4,v.yCbCr=!0;else if(k.R&&k.G&&k.B)v.outputChannels=4;else if(k.Y)v.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(v.outputChannels){case 4:R==ut?(E=!k.A,v.format=ut,v.colorSpace=ft,v.outputChannels=4,v.decodeChannels={R:0,G:1,B:2,A:3}):R==tn?(v.format=tn,v.colorSpace=ft,v.outputChannels=2,v.decodeChannels={R:0,G:1}):R==kn?(v.format=kn,v.colorSpace=ft,v.outputChannels=1,v.decodeChannels={R:0}):S=!0;break;case 1:R==ut?(E=!0,v.format=ut,v.colorSpace=ft,v.outputChannels=4,v.shouldExpand=!0,v.decodeChannels={Y:0}):R==tn?(v.format=tn,v.colorSpace=ft,v.outputChannels=2,v.shouldExpand=!0,v.decodeChannels={Y:0}):R==kn?(v.format=kn,v.colorSpace=ft,v.outputChannels=1,v.decodeChannels={Y:0}):S=!0;break;default:S=!0}if(S)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(v.yCbCr&&(v.format=ut,v.outputChannels=4,v.decodeChannels={Y:0,RY:1,BY:2},E=!0),v.type==1)switch(x){case Qt:v.getter=Rc;break;case en:v.getter=_n;break}else if(v.type==2)switch(x){case Qt:v.getter=fe;break;case en:v.getter=Ec}else throw new Error("THREE.EXRLoader: unsupported pixelType "+v.type+" for "+c.compression+".");v.columns=v.width;let N=v.width*v.height*v.outputChannels;switch(x){case Qt:v.byteArray=new Float32Array(N),E&&v.byteArray.fill(1,0,N);break;case en:v.byteArray=new Uint16Array(N),E&&v.byteArray.fill(15360,0,N);break;default:console.error("THREE.EXRLoader: unsupported type: ",x);break}let O=0;for(let I of c.channels)v.decodeChannels[I.name]!==void 0&&(v.channelByteOffsets[I.name]=O),O+=I.pixelType*2;if(v.totalBytes=O,v.outLineWidth=v.width*v.outputChannels,c.spec.deepFormat){v.deepChannels=[];let I=0;for(let P of c.channels){let z=P.pixelType===0?4:P.pixelType*2;v.deepChannels.push({name:P.name,pixelType:P.pixelType,bytesPerSample:z}),I+=z}v.deepBytesPerSample=I,v.chunkOffsets=c._chunkOffsets,v.multiPart=c.spec.multiPart,v.decode=Hc.bind(v)}else if(c.spec.singleTile){v.blockHeight=c.tiles.ySize,v.blockWidth=c.tiles.xSize;let I=zc(c.tiles,v.width,v.height),P=ji(I,v.width,c.tiles.xSize,c.tiles.roundingMode),z=ji(I,v.height,c.tiles.ySize,c.tiles.roundingMode);v.tileCount=P[0]*z[0];for(let M=0;M<I;M++)for(let C=0;C<z[M];C++)for(let H=0;H<P[M];H++)ae(h,y);v.decode=Uc.bind(v)}else if(c.spec.multiPart)v.blockWidth=v.width,v.chunkOffsets=c._chunkOffsets,v.decode=Bc.bind(v);else{v.blockWidth=v.width;let I=Math.ceil(v.height/v.blockHeight);for(let P=0;P<I;P++)ae(h,y);v.decode=Dc.bind(v)}return v}let Yn={value:0},Kn=new DataView(e),qc=new Uint8Array(e),Xn=Gc(Kn,e,Yn),Zi=Math.max(0,Math.min(this.part,Xn.length-1)),he=Xn[Zi];if(he.spec.multiPart||he.spec.deepFormat)for(let c=0;c<Xn.length;c++){let h=Xn[c].chunkCount;if(c===Zi){he._chunkOffsets=[];for(let d=0;d<h;d++)he._chunkOffsets.push(ae(Kn,Yn))}else for(let d=0;d<h;d++)ae(Kn,Yn)}let Ae=$c(he,Kn,qc,Yn,this.type,this.outputFormat);if(Ae.decode(),Ae.shouldExpand){let c=Ae.byteArray;if(this.outputFormat==ut)for(let h=0;h<c.length;h+=4)c[h+2]=c[h+1]=c[h];else if(this.outputFormat==tn)for(let h=0;h<c.length;h+=2)c[h+1]=c[h]}if(Ae.yCbCr){let c=Ae.byteArray,h=Ae.width*Ae.height;if(this.type===en)for(let d=0;d<h;d++){let y=d*4,x=L.fromHalfFloat(c[y]),R=L.fromHalfFloat(c[y+1]),v=L.fromHalfFloat(c[y+2]),k=(1+R)*x,E=(1+v)*x,S=(x-k*.2126-E*.0722)/.7152;c[y]=L.toHalfFloat(Math.max(0,k)),c[y+1]=L.toHalfFloat(Math.max(0,S)),c[y+2]=L.toHalfFloat(Math.max(0,E))}else for(let d=0;d<h;d++){let y=d*4,x=c[y],R=c[y+1],v=c[y+2],k=(1+R)*x,E=(1+v)*x;c[y]=Math.max(0,k),c[y+1]=Math.max(0,(x-k*.2126-E*.0722)/.7152),c[y+2]=Math.max(0,E)}}return{header:he,width:Ae.width,height:Ae.height,data:Ae.byteArray,format:Ae.format,colorSpace:Ae.colorSpace,type:this.type,minFilter:Ys,magFilter:Ys,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var Ya=32768,vf=2**27,Ka=2**28,Xa=1024,yf=12,Qs=2**29,Ja=1e18,ei=65504;function Er(r,e,t){let n=Math.max(r,e)>Ya||r*e>vf;if(Math.min(r,e)<1||n)throw new $(`has ${r} x ${e} pixels; from 1 to ${Ya} a side, 2^27 in all`);let s=r*e*yf;if(s>Ka&&s>Xa*t)throw new $(`has ${r} x ${e} pixels in ${t} bytes; an image above ${Ka} bytes of radiance is at most ${Xa} times its file`)}var wf=512,bf=2048,xf=4096,Sr=["NO","RLE","ZIPS","ZIP","PIZ","PXR24","B44","B44A","DWAA","DWAB"],Af=0,Ef=2,Rf=2,Sf=4096,Qa=["RY","BY"];function eo(r){let{parts:e,flags:t}=Mf(r),n=Nf(e),s=e[n];If(s,e.length,t);for(let F of[s.dataWindow,s.displayWindow])Er(...Rr(F),r.length);let i=e.reduce((F,G)=>F+Math.max(0,kf(G)),0);if(i>Qs)throw new $(`has ${i} values in all its channels; at most ${Qs}`);let a=s.dataWindow,o=s.displayWindow,l=Math.max(a[0],o[0]),u=Math.min(a[2],o[2]),f=Math.max(a[1],o[1]),p=Math.min(a[3],o[3]);if(l>u||f>p)throw new $("its data window lies outside its display window");Tf(s);let g=new Ar().setDataType(Qt).setPart(n).parse(Of(r,s).buffer),[_,w]=Rr(o),[A]=Rr(a),T=new Float32Array(3*_*w);for(let F=f;F<=p;F++){let G=a[3]-F;for(let te=l;te<=u;te++){let le=4*(G*A+te-a[0]),we=3*((F-o[1])*_+te-o[0]);for(let ne=0;ne<3;ne++)T[we+ne]=g.data[le+ne]}}return{rgb:T,width:_,height:w}}function Rr([r,e,t,n]){return[t-r+1,n-e+1]}function kf({dataWindow:r,channels:e}){let[t,n]=Rr(r);return Math.max(0,t)*Math.max(0,n)*e.length}function ni({channels:r}){let e=new Set(r.map(({name:t})=>t));return e.has("R")&&e.has("G")&&e.has("B")?["R","G","B"]:e.has("Y")&&!Qa.some(t=>e.has(t))?["Y"]:[]}function Nf(r){let e=r.findIndex(s=>ni(s).length>0);if(e>=0)return e;let t=[...new Set(r.flatMap(({channels:s})=>s.map(({name:i})=>i)))].sort();if(["Y",...Qa].every(s=>t.includes(s)))throw new $("has luminance and chroma (Y, RY, BY): save it with R, G and B");let n=t.length>12?` and ${t.length-12} more`:"";throw new $(`has no channels R, G and B, nor Y; it has ${t.slice(0,12).join(", ")||"none"}${n}`)}function If(r,e,t){let n=r.type?r.type.startsWith("deep"):(t&bf)!==0,s=r.type?r.type==="tiledimage":(t&wf)!==0,i=a=>{throw new $(a)};n&&i("is a deep image, with any number of samples a pixel: flatten it"),r.envmap&&i("is a cube map: convert it to latitude and longitude"),r.channels.some(({x:a,y:o})=>a!==1||o!==1)&&i("has channels of fewer texels than others: save them all at full size"),Sr[r.compression]===void 0&&i(`has compression ${r.compression}, expected one of ${Sr.join(", ")}`),s&&e>1&&i("has tiles in one of several parts: save it with scan lines"),s&&r.levels===Rf&&i("has tiles of several sizes by row and column: save it with one size")}function Tf(r){let e=ni(r),t=new Set;for(let{name:n,type:s}of r.channels)e.includes(n)&&t.add(["uint32","float16","float32"][s]);if(t.size>1||t.has("uint32"))throw new $(`has colours of type ${[...t].sort().join(", ")}, expected float16 or float32`)}function Of(r,e){let t=r.slice(),n=ni(e),s=e.channels.find(({name:a})=>a===n[0]).type,i=["DWAA","DWAB"].includes(Sr[e.compression]);for(let a of e.channels)if(a.type===Af&&Sr[e.compression]!=="PXR24"&&(t[a.typeAt]=Ef),["A","Y","RY","BY"].includes(a.name)&&!n.includes(a.name)&&!(i&&a.type===s))for(let l=0;l<a.name.length;l++)t[a.at+l]|=32;return t}function Mf(r){let e=new DataView(r.buffer,r.byteOffset,r.length),t=e.getUint32(4,!0),n={bytes:r,view:e,at:8},s=[];do{let i=Lf(n);if(i===null)break;s.push(i)}while(t&xf);if(!s.length)throw new $("broken EXR image: it has no header");return{parts:s,flags:t}}function Lf(r){let e={channels:null,compression:null,dataWindow:null,displayWindow:null,type:"",envmap:0,levels:0},{view:t}=r;for(let s=0;;s++){let i=ti(r);if(i===""){if(s===0)return null;break}let a=ti(r),o=t.getInt32(r.at,!0),l=r.at+4;if(o<0||l+o>r.bytes.length||s>Sf)throw new $("broken EXR image: an attribute goes past the file's end");i==="channels"&&(e.channels=Pf({...r,at:l})),i==="compression"&&(e.compression=t.getUint8(l)),(i==="dataWindow"||i==="displayWindow")&&(e[i]=[0,4,8,12].map(u=>t.getInt32(l+u,!0))),i==="type"&&(e.type=String.fromCharCode(...r.bytes.subarray(l,l+Math.min(o,64)))),i==="envmap"&&a==="envmap"&&(e.envmap=t.getUint8(l)),i==="tiles"&&(e.levels=t.getUint8(l+8)&15),r.at=l+o}let n=["channels","compression","dataWindow","displayWindow"].find(s=>e[s]===null);if(n!==void 0)throw new $(`broken EXR image: it has no ${n}`);return e}function Pf(r){let e=[];for(;;){let t=r.at,n=ti(r);if(n==="")return e;let s=r.at,{view:i}=r;e.push({name:n,at:t,typeAt:s,type:i.getInt32(s,!0),x:i.getInt32(s+8,!0),y:i.getInt32(s+12,!0)}),r.at+=16}}function ti(r){let e=r.bytes.indexOf(0,r.at);if(e<0||e-r.at>255)throw new $("broken EXR image: its header does not end");let t=new TextDecoder("utf-8",{fatal:!0}).decode(r.bytes.subarray(r.at,e));return r.at=e+1,t}var Ff=65536,to=[8,32767],Cf=/^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/,zf=/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/,ri=/^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g,ke=r=>new $(`broken HDR image${r}`);function no(r){let e=Uf(r),{count:t,length:n,columns:s,back:i,exposure:a}=e,o=Df(r,e),l=1/a,[u,f]=s?[t,n]:[n,t],p=new Float32Array(3*u*f);for(let m=0;m<t;m++){let g=i[0]?t-1-m:m;for(let _=0;_<n;_++){let w=i[1]?n-1-_:_,A=4*(m*n+_),T=3*(s?w*u+g:g*u+w),F=o[A+3],G=F>0?l*2**(F-136):0;for(let te=0;te<3;te++)p[T+te]=o[A+te]*G}}return{rgb:p,width:u,height:f}}function Uf(r){let e=[],t=0,n=-1;for(;n<0||e.length<n+2;){let p=r.subarray(0,Ff).indexOf(10,t);if(p<0)throw ke(": it has no header");e.push(Array.from(r.subarray(t,p),m=>String.fromCharCode(m)).join("")),t=p+1,n<0&&e.at(-1).replace(/\r+$/,"")===""&&(n=e.length-1)}let s=1;for(let p of e.slice(1,n)){let m=p.indexOf("="),[g,_]=m<0?[p,""]:[p.slice(0,m),p.slice(m+1)],w=g.replace(ri,""),A=_.replace(ri,"");if(w==="FORMAT"&&A!=="32-bit_rle_rgbe")throw ke(`: format '${A}', expected 32-bit_rle_rgbe`);w==="EXPOSURE"&&(s*=zf.test(A)?Number(A)||1:0)}if(!(s>0&&s<1/0))throw ke(": EXPOSURE is not a positive number");let i=e[n+1].replace(ri,""),a=Cf.exec(i);if(a===null||a[2]===a[5])throw ke(`: size '${i.slice(0,40)}', expected such as '-Y height +X width'`);let o=Number(a[3]),l=Number(a[6]),u=a[2]==="X",f=[a[1]+a[2],a[4]+a[5]].map(p=>p==="+Y"||p==="-X");return Er(...u?[o,l]:[l,o],r.length),{offset:t,count:o,length:l,columns:u,back:f,exposure:s}}function Df(r,{offset:e,count:t,length:n}){let s=new Uint8Array(4*t*n),i=e;try{for(let a=0;a<t;a++)i=Bf(r,i,s.subarray(4*a*n),n,a)}catch(a){if(r.length-e===s.length)return r.subarray(e);throw a}return s}function Bf(r,e,t,n,s){if(n>=to[0]&&n<=to[1]&&e+4<=r.length&&r[e]===2&&r[e+1]===2&&r[e+2]<128){if(r[e+2]*256+r[e+3]!==n)throw ke(`, line ${s}: a run goes past the line's end`);return Hf(r,e+4,t,n,s)}return Gf(r,e,t,n,s)}function Hf(r,e,t,n,s){for(let i=0;i<4;i++)for(let a=0;a<n;){if(e+2>r.length)throw ke(`, line ${s}: the file ends there`);let o=r[e]>128,l=o?r[e]-128:r[e];if(l===0)throw ke(`, line ${s}: a run of no pixels`);if(a+l>n)throw ke(`, line ${s}: a run goes past the line's end`);if(e+1+(o?1:l)>r.length)throw ke(`, line ${s}: the file ends there`);for(let u=0;u<l;u++)t[4*(a+u)+i]=r[e+1+(o?0:u)];a+=l,e+=o?2:1+l}return e}function Gf(r,e,t,n,s){let i=0,a=0;for(;i<n;){if(e+4>r.length)throw ke(`, line ${s}: the file ends there`);if(r[e]===1&&r[e+1]===1&&r[e+2]===1){if(i===0)throw ke(`, line ${s}: a run repeats a pixel, but there is none before it`);let o=a>16?1/0:r[e+3]*2**a;if(i+o>n)throw ke(`, line ${s}: a run goes past the line's end`);for(let l=0;l<o;l++)t.copyWithin(4*(i+l),4*(i-1),4*i);i+=o,a+=8}else t.set(r.subarray(e,e+4),4*i),i+=1,a=0;e+=4}return e}var $f=[118,47,49,1],qf=[35,63];function si(r,e){let t=new Uint8Array(r),n=i=>i.every((a,o)=>t[o]===a),s=n($f)?eo:n(qf)?no:null;if(s===null)throw new $(`${e}: is ${ct(t)??"neither an EXR nor a Radiance HDR image"}`);try{return jf(s(t),e)}catch(i){let a=i instanceof $?i.message:`cannot read the image: ${i.message??i}`;throw new $(`${e}: ${a}`)}}function jf(r,e){let{rgb:t}=r,n=0,s=0;for(let i=0;i<t.length;i+=3){let a=!0;(t[i]===1/0||t[i+1]===1/0||t[i+2]===1/0)&&s++;for(let o=i;o<i+3;o++)t[o]===1/0&&(t[o]=ei),a&&=Number.isFinite(t[o])&&t[o]<=Ja,t[o]>0||(t[o]=0);a||n++}if(n)throw new $(`has ${n} texels that are not finite numbers of at most 1e+18`);return s&&console.warn(`${e}: infinite radiance in ${s} texels is cut to ${ei}: the sun is darker`),r}function ro(r){return r.replaceAll("#","%23").replace(/%(?![0-9a-f]{2})/gi,"%25")}var Vf=64,Wf=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,Zf=/[ \t\n\r]*/y,Yf=/[^"\\\u0000-\u001f]*/y,so={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function ht(r,e,t){let n;try{n=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(r)}catch{b(t,e,"no UTF-8")}let s=new ii(n,e,t);s.space(),n[s.at]!=="{"&&b(t,e,"not a JSON object");let i=s.value(1);return s.space(),s.at!==n.length&&s.bad(),i}function io(){}io.prototype=Object.create(null);var ii=class{constructor(e,t,n){Object.assign(this,{text:e,where:t,code:n,at:0})}bad(e="malformed JSON"){b(this.code,this.where,`${e} at character ${this.at}`)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t&&(this.at=e.lastIndex),t}space(){this.match(Zf)}take(e){return this.text.startsWith(e,this.at)?(this.at+=e.length,!0):!1}value(e){let t=this.text[this.at];if((t==="{"||t==="[")&&e>Vf&&this.bad("nested too deep"),t==="{")return this.object(e);if(t==="[")return this.array(e);if(t==='"')return this.string();for(let[i,a]of[["true",!0],["false",!1],["null",null]])if(this.take(i))return a;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let n=this.match(Wf);n||this.bad();let s=Number(n[0]);return Number.isFinite(s)||this.notFinite(),s===0?0:s}notFinite(){b("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(e,t){if(this.at+=1,this.space(),!this.take(e)){do this.space(),t(),this.space();while(this.take(","));this.take(e)||this.bad()}}array(e){let t=[];return this.list("]",()=>t.push(this.value(e+1))),t}object(e){let t=new io;return this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let n=this.string();n in t&&b("JSON_DUPLICATE_KEY",this.where,`the key "${n}" twice`),this.space(),this.take(":")||this.bad(),this.space(),t[n]=this.value(e+1)}),t}string(){let e="";for(this.at+=1;e+=this.match(Yf)[0],!this.take('"');){this.take("\\")||this.bad();let t=this.text[this.at++];if(t==="u"){let n=this.match(/[0-9a-fA-F]{4}/y);n||this.bad(),e+=String.fromCharCode(parseInt(n[0],16))}else t in so?e+=so[t]:this.bad()}return e.isWellFormed()||this.bad("half of a surrogate pair"),e}};var ai={object:r=>r!==null&&typeof r=="object"&&!Array.isArray(r),array:Array.isArray,string:r=>typeof r=="string",number:r=>typeof r=="number",integer:r=>Number.isSafeInteger(r),boolean:r=>typeof r=="boolean",null:r=>r===null};function sn(r,e,t=""){new li(r).check(r,e,t)}var li=class{constructor(e){this.root=e}fits(e,t){try{return this.check(e,t,""),!0}catch{return!1}}check(e,t,n){e.$ref&&this.check(this.root.$defs[e.$ref.split("/").pop()],t,n);let s=i=>b("FIELD_VALUE",n,`found ${oi(t)}, expected ${i}`);e.type&&!ai[e.type](t)&&s(e.type),"const"in e&&t!==e.const&&s(oi(e.const)),e.enum&&!e.enum.includes(t)&&(e.enum.includes("features")&&b("INPUT_UNKNOWN",n,`no block ${oi(t)}`),s(e.enum.join(", ")));for(let i of[e.anyOf,e.oneOf])i&&!i.some(a=>this.fits(a,t))&&this.check(i.find(a=>ai[a.type]?.(t))??i[0],t,n);e.not&&this.fits(e.not,t)&&s("another value"),typeof t=="number"&&this.checkNumber(e,t,s),typeof t=="string"&&this.checkString(e,t,s),Array.isArray(t)?this.checkArray(e,t,n,s):ai.object(t)&&this.checkObject(e,t,n)}checkNumber(e,t,n){t<e.minimum&&n(`at least ${e.minimum}`),t>e.maximum&&n(`at most ${e.maximum}`),t<=e.exclusiveMinimum&&n(`more than ${e.exclusiveMinimum}`),t>=e.exclusiveMaximum&&n(`less than ${e.exclusiveMaximum}`)}checkString(e,t,n){t.length<e.minLength&&n(`${e.minLength} characters or more`),t.length>e.maxLength&&n(`at most ${e.maxLength} characters`),e.pattern&&!new RegExp(e.pattern,"u").test(t)&&n(e.pattern)}checkArray(e,t,n,s){t.length<e.minItems&&s(`${e.minItems} items or more`),t.length>e.maxItems&&s(`at most ${e.maxItems} items`),t.forEach((i,a)=>{let o=e.prefixItems?.[a]??e.items;o&&this.check(o,i,`${n}/${a}`)}),e.uniqueItems&&new Set(t).size!==t.length&&b("INPUT_UNKNOWN",n,"a name twice")}checkObject(e,t,n){let s=Object.keys(t),i=e.properties??{};for(let a of s)e.additionalProperties===!1&&!Object.hasOwn(i,a)&&b("FIELD_UNKNOWN",`${n}/${a}`,"no such member"),e.propertyNames&&this.check({type:"string",...e.propertyNames},a,`${n}/${a}`);for(let a of e.required??[])Object.hasOwn(t,a)||b("FIELD_MISSING",`${n}/${a}`,"missing");for(let a of s){let o=Object.hasOwn(i,a)?i[a]:e.additionalProperties;o&&this.check(o,t[a],`${n}/${a}`)}}};function oi(r){let e=JSON.stringify(r);return e.length>60?`${e.slice(0,57)}...`:e}var pt={type:"string"},ao={type:"array",items:{type:"number"}},Ue=r=>({type:"integer",minimum:r,maximum:2**32-1}),mt=r=>({type:"array",minItems:1,maxItems:1,items:r}),De=(r,e={})=>({type:"object",properties:{...r,...e},required:Object.keys(r),additionalProperties:!1}),oo={type:"array",minItems:3,maxItems:3,items:{type:"number"}},lo={const:"KHR_mesh_quantization"};function co(r){let e=r?[5122,5123,5125,5126]:[5125,5126],t=De({bufferView:Ue(0),componentType:{enum:e},count:Ue(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:Ue(0),normalized:r?{type:"boolean"}:{const:!1},min:ao,max:ao,name:pt}),n=De({buffer:{const:0},byteLength:Ue(1)},{byteOffset:Ue(0),target:{enum:[34962,34963]},name:pt,...r&&{byteStride:{enum:[4,8]}}}),s=De({POSITION:Ue(0),NORMAL:Ue(0)},{TEXCOORD_0:Ue(0)}),i=De({attributes:s,indices:Ue(0)},{mode:{const:4}});return De({asset:De({version:{const:"2.0"}},{generator:pt,copyright:pt}),scenes:mt(De({nodes:mt({const:0})},{name:pt})),nodes:mt(De({mesh:{const:0},...r&&{translation:oo,scale:oo}},{name:pt})),meshes:mt(De({primitives:mt(i)},{name:pt})),buffers:mt(De({byteLength:Ue(1)},{name:pt})),accessors:{type:"array",minItems:3,maxItems:4,items:t},bufferViews:{type:"array",minItems:1,maxItems:4,items:n},...r&&{extensionsUsed:mt(lo),extensionsRequired:mt(lo)}},{scene:{const:0},extras:{}})}var Kf=co(!1),Xf=co(!0);function uo(r,e){let t="extensionsUsed"in r||"extensionsRequired"in r;try{sn(t?Xf:Kf,r)}catch(n){b("GEOMETRY_PROFILE",e,`${n.where}: not as meshes of packages are`)}return t&&Jf(r.nodes[0],e),Qf(r,t,e),t}function Jf({scale:[r,e,t]},n){r>0&&r===e&&r===t||b("GEOMETRY_PROFILE",n,`the scale ${[r,e,t]}`)}function Qf(r,e,t){let{attributes:n,indices:s}=r.meshes[0].primitives[0],i=e?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[o,l]of[...Object.entries(n),["indices",s]]){let u=r.accessors[l],f=u&&r.bufferViews[u.bufferView];if(!f)continue;let[p,m]=i[o];p.includes(u.type)&&m.some(([_,w,A])=>u.componentType===_&&(u.normalized??!1)===w&&f.byteStride===A)||b("GEOMETRY_PROFILE",t,`the accessor of ${o}`)}r.accessors[s]?.componentType===5123&&r.accessors[n.POSITION]?.count>=65535&&b("GEOMETRY_PROFILE",t,"indices of 16 bits for too many vertices")}var fo={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},eh=65536;function an(r,e,t,n){let s=e.byteOffset+t;return s%r.BYTES_PER_ELEMENT===0?new r(e.buffer,s,n):new r(e.slice(t,t+n*r.BYTES_PER_ELEMENT).buffer)}function dt(r,e,t){r.length<8&&b(t,e,"shorter than a header");let n=new DataView(r.buffer,r.byteOffset).getBigUint64(0,!0);(n>eh||Number(n)>r.length-8)&&b(t,e,`a header of ${n} bytes`);let s=8+Number(n);r[8]!==123&&b(t,e,"the header does not start with {");let{__metadata__:i,...a}=ht(r.subarray(8,s),e,t);return{tensors:a,metadata:i,data:s}}var kr=r=>r!==null&&typeof r=="object"&&!Array.isArray(r),th=r=>Number.isSafeInteger(r)&&r>=0,ho=r=>Array.isArray(r)&&r.every(th),gt=r=>kr(r)&&typeof r.dtype=="string"&&ho(r.shape),_t=r=>r===void 0||kr(r);function vt(r,{tensors:e,data:t},n,s,i){let a=0,o=n.map(l=>{let{dtype:u,shape:f,data_offsets:p}=e[l];(!ho(p)||p.length!==2)&&b(i,s,`${l}: data_offsets are not two counts`);let[m,g]=p,_=f.reduce((w,A)=>w*A,1);return(m!==a||g-m!==_*fo[u].BYTES_PER_ELEMENT||t+g>r.length)&&b(i,s,`the bytes of ${l} are not where they must be`),a=g,an(fo[u],r,t+m,_)});return t+a!==r.length&&b(i,s,"bytes behind the last tensor"),o}var nh={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},rh={SCALAR:1,VEC2:2,VEC3:3};function Nr(r,e){let{json:t,bin:n}=ci(r,e),s=uo(t,e),i=t.buffers[0].byteLength;(i>n.length||n.length-i>3)&&b("GEOMETRY_RANGE",e,`a buffer of ${i} bytes in a chunk of ${n.length}`);let a=t.meshes[0].primitives[0],o=f=>ui(t,n.subarray(0,i),f,e),l={positions:o(a.attributes.POSITION),normals:o(a.attributes.NORMAL),uvs:"TEXCOORD_0"in a.attributes?o(a.attributes.TEXCOORD_0):null,indices:o(a.indices)};sh(l,e),ih(t.accessors[a.attributes.POSITION],l.positions,s,e);let u=s?ah(l,t.nodes[0]):l;return u.indices=Uint32Array.from(l.indices),fi(u,e),u}function ci(r,e){let t="GEOMETRY_CONTAINER",n=new DataView(r.buffer,r.byteOffset,r.length);(r.length<20||n.getUint32(0,!0)!==1179937895||n.getUint32(4,!0)!==2)&&b(t,e,"no binary glTF 2.0"),n.getUint32(8,!0)!==r.length&&b(t,e,"the length in the header is not that of the entry");let s=[];for(let i=12;i<r.length;){i+8>r.length&&b(t,e,"a chunk is cut short");let a=n.getUint32(i,!0),o=n.getUint32(i+4,!0);(a%4||i+8+a>r.length)&&b(t,e,`a chunk of ${a} bytes`),s.push([o,r.subarray(i+8,i+8+a)]),i+=8+a}return s.map(([i])=>i).join()!==[1313821514,5130562].join()&&b(t,e,"not the chunks JSON and BIN"),s[0][1].length>65536&&b(t,e,"JSON of more than 64 KiB"),{json:ht(s[0][1],e,t),bin:s[1][1]}}function ui(r,e,t,n){let s=r.accessors[t];s||b("GEOMETRY_RANGE",n,`no accessor ${t}`);let i=r.bufferViews[s.bufferView];i||b("GEOMETRY_RANGE",n,`no buffer view ${s.bufferView}`);let a=nh[s.componentType],o=rh[s.type],l=a.BYTES_PER_ELEMENT*o,u=i.byteStride??l,f=(i.byteOffset??0)+(s.byteOffset??0),p=(s.byteOffset??0)+u*(s.count-1)+l;(p>i.byteLength||(i.byteOffset??0)+i.byteLength>e.length)&&b("GEOMETRY_RANGE",n,`accessor ${t} reaches past its bytes`),f%4&&b("GEOMETRY_RANGE",n,`accessor ${t} is not aligned`);let m=u===l?an(a,e,f,o*s.count):new a(o*s.count);if(u!==l){let g=an(a,e,f,Math.floor(p-(s.byteOffset??0))/a.BYTES_PER_ELEMENT),_=u/a.BYTES_PER_ELEMENT;for(let w=0;w<s.count;w++)for(let A=0;A<o;A++)m[o*w+A]=g[_*w+A]}return Object.assign(m,{items:o})}function sh({positions:r,normals:e,uvs:t,indices:n},s){let i=r.length/3;(e.length!==r.length||t&&t.length!==2*i||!i)&&b("GEOMETRY_ARRAY",s,"attributes of different counts"),(n.length%3||!n.length)&&b("GEOMETRY_ARRAY",s,"part of a triangle")}function ih(r,e,t,n){["min","max"].every(i=>{if(r[i]?.length!==3)return!1;for(let a=0;a<3;a++){let o=e[a];for(let u=a;u<e.length;u+=3)(i==="min"?e[u]<o:e[u]>o)&&(o=e[u]);if((t?r[i][a]:Math.fround(r[i][a]))!==o&&Number.isFinite(o))return!1}return!0})||b("GEOMETRY_BOUNDS",n,"min and max of POSITION are not those of its values")}function ah({positions:r,normals:e,uvs:t},{translation:n,scale:s}){return{positions:Float32Array.from(r,(i,a)=>n[a%3]+s[0]*i),normals:Float32Array.from(e,i=>Math.max(i/32767,-1)),uvs:t&&(t instanceof Uint16Array?Float32Array.from(t,i=>i/65535):t)}}function fi({positions:r,normals:e,uvs:t,indices:n},s){for(let a of[r,e,t??[]])for(let o=0;o<a.length;o++)Number.isFinite(a[o])||b("GEOMETRY_NOT_FINITE",s,"an attribute is not finite");let i=r.length/3;for(let a=0;a<n.length;a++)n[a]>=i&&b("GEOMETRY_INDEX",s,`vertex ${n[a]} of ${i}`);for(let a=0;a<e.length;a+=3){let o=Math.hypot(e[a],e[a+1],e[a+2]);Math.abs(o-1)>.001&&b("GEOMETRY_NORMAL",s,`a normal of length ${o}`)}}var oh=.1,lh=[5123,5125];function po(r,e){let t=ct(r);if(t)throw new $(`${e}: expected a .glb, found ${t}`);let{json:n,bin:s}=ci(r,e),i=f=>ui(n,s,f,e),a=f=>{throw new $(`${e}: expected ${f}, as rna-capture writes it`)},o=(n.nodes??[]).filter(({mesh:f})=>f!==void 0);o.some(f=>["matrix","translation","rotation","scale","skin"].some(p=>p in f))&&a("a mesh that stands where the asset does, without a transform");let l=o.flatMap(({mesh:f})=>n.meshes[f].primitives).map(({attributes:f,indices:p,material:m,mode:g=4})=>{let w=[[f.POSITION,"VEC3",[5126]],[f.NORMAL,"VEC3",[5126]],[p,"SCALAR",lh]].every(([A,T,F])=>{let G=n.accessors?.[A];return G&&G.type===T&&F.includes(G.componentType)});return(g!==4||!w)&&a("triangles with positions, normals and indices"),{positions:i(f.POSITION),normals:i(f.NORMAL),indices:i(p),material:m}});l.length||a("a mesh");let u=l.map(({material:f})=>ch(n.materials?.[f])??a("smooth glass, of KHR_materials_transmission 1 and KHR_materials_volume"));return{...uh(l,e),materials:u}}function ch({pbrMetallicRoughness:{baseColorFactor:r=[1,1,1],metallicFactor:e=1,roughnessFactor:t=1,...n}={},extensions:s={}}={}){let{KHR_materials_transmission:i,KHR_materials_volume:a,KHR_materials_ior:{ior:o=1.5}={}}=s;if(!(i?.transmissionFactor===1&&a?.thicknessFactor>0&&e===0&&t<=oh)||!(o>=1)||[n,i,a].some(m=>Object.keys(m).some(g=>g.endsWith("Texture"))))return null;let{attenuationColor:u=[1,1,1],attenuationDistance:f=1/0}=a,p=u.map(m=>-Math.log(Math.max(m,1e-6))/f);return{ior:o,tint:r.slice(0,3),absorption:p}}function uh(r,e){let t=r.reduce((o,{positions:l})=>o+l.length,0),n=r.flatMap(({indices:o},l)=>Array(o.length/3).fill(l)),s={positions:new Float32Array(t),normals:new Float32Array(t),uvs:null,indices:new Uint32Array(3*n.length)},i=0,a=0;for(let{positions:o,normals:l,indices:u}of r)fi({positions:o,normals:l,uvs:null,indices:u},e),s.positions.set(o,i),s.normals.set(l,i),s.indices.set(u.map(f=>f+i/3),a),i+=o.length,a+=u.length;return{mesh:s,materialOf:n}}var mo={blocks:[{name:"features",width:null,kinds:["surface","fiber"],light:!1},{name:"position",width:3,kinds:["surface","fiber"],light:!1},{name:"normal",width:3,kinds:["surface"],light:!1},{name:"tangent",width:3,kinds:["fiber"],light:!1},{name:"h",width:1,kinds:["fiber"],light:!1},{name:"wo",width:3,kinds:["surface","fiber"],light:!1},{name:"wi",width:3,kinds:["surface","fiber"],light:!0},{name:"half_vector",width:5,kinds:["surface"],light:!0},{name:"highlight",width:1,kinds:["surface"],light:!0},{name:"learned_normal",width:2,kinds:["surface"],light:!0},{name:"fiber_angles",width:6,kinds:["fiber"],light:!0},{name:"fiber_lobes",width:3,kinds:["fiber"],light:!0}]};var Ir=mo.blocks,Ft=r=>Ir.find(e=>e.name===r),Tr=(r,e)=>Ft(r).width??e;var yt=22,Ct=46,Tn=30,go=64,_o=256,hh=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,on="manifest.json",vo=2**20,Mn=r=>new DataView(r.buffer,r.byteOffset,r.byteLength);async function wo(r){let{size:e}=r;e===0&&b("FILE_EMPTY",r.name,"the file has no bytes"),e>2**32-2&&b("FILE_TOO_LARGE",r.name,`${e} bytes`);let{count:t,start:n}=await ph(r),s=await r.read(n,e-yt),i=dh(s,t,n,r.name);return _h(i,n,r.name),new Map(i.map(a=>[a.name,a]))}async function ph(r){let{size:e,name:t}=r,n=await r.read(0,Math.min(512,e)),s=ct(n)??Ua(n);s&&b("ZIP_NOT_ZIP",t,`expected a package, found ${s}`);let a=e>=4&&Mn(n).getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";e<yt&&b(a,t,"shorter than the end record of a ZIP archive");let o=Mn(await r.read(e-yt,e)),l=e===yt&&o.getUint32(0,!0)===101010256;o.getUint32(0,!0)!==101010256&&await mh(r,a);let u=g=>o.getUint16(g,!0);[4,6,8,10].some(g=>u(g)===65535)&&b("ZIP_ZIP64",t,"a ZIP64 archive"),(u(4)||u(6))&&b("ZIP_ZIP64",t,"an archive of several disks");let f=u(10),p=o.getUint32(12,!0),m=o.getUint32(16,!0);return f>_o&&b("ZIP_TOO_MANY",t,`${f} entries; at most ${_o}`),(u(8)!==f||u(20)!==0||m+p!==e-yt)&&b("ZIP_DIRECTORY",t,"the end record does not fit the central directory"),(l||f===0)&&b("ZIP_ORDER",t,`${on} is not the first entry`),{count:f,start:m}}async function mh(r,e){let t=await r.read(Math.max(0,r.size-yt-65535),r.size),n=Mn(t);for(let s=t.length-yt;s>=0;s--)n.getUint32(s,!0)===101010256&&s+yt+n.getUint16(s+20,!0)===t.length&&b("ZIP_DIRECTORY",r.name,"the archive has a comment");b(e,r.name,"the file does not end with the end record of a ZIP archive")}function dh(r,e,t,n){let s=Mn(r),i=[],a=new Set,o=0;for(let l=0;l<e;l++){(o+Ct>r.length||s.getUint32(o,!0)!==33639248)&&b("ZIP_DIRECTORY",n,`the central directory has no header ${l}`);let u=s.getUint16(o+28,!0);(o+Ct+u>r.length||s.getUint32(o+30,!0))&&b("ZIP_DIRECTORY",n,`header ${l} of the central directory is malformed`);let f=r.subarray(o+Ct,o+Ct+u),p=String.fromCharCode(...f);gh(s,o,p,n),(!hh.test(p)||p.includes(`
`)||u>200)&&b("ZIP_NAME",n,`an entry is called ${JSON.stringify(p.slice(0,80))}`);let m=p.toLowerCase();a.has(m)&&b("ZIP_DUPLICATE",p,"the name is there twice"),a.add(m),i.push({name:p,size:s.getUint32(o+24,!0),crc:s.getUint32(o+16,!0),header:s.getUint32(o+42,!0),central:r.subarray(o,o+Ct+u)}),o+=Ct+u}o!==r.length&&b("ZIP_DIRECTORY",n,"bytes behind the last central header");for(let{name:l,header:u,size:f}of i)u+Tn+l.length+f>t&&b("ZIP_TRUNCATED",l,`${f} bytes reach past the entries`);return i}function gh(r,e,t,n){let s=l=>r.getUint16(e+l,!0),i=l=>r.getUint32(e+l,!0),a=JSON.stringify(t.slice(0,80));(i(42)===4294967295||i(20)===4294967295||i(24)===4294967295)&&b("ZIP_ZIP64",n,`${a} needs ZIP64`),s(34)&&b("ZIP_ZIP64",n,`${a} is on another disk`),s(8)&1&&b("ZIP_ENCRYPTED",n,`${a} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([l,u])=>s(l)!==u)||i(38))&&b("ZIP_HEADER",n,`${a}: a version, flag, time or attribute is not the fixed one`),s(10)&&b("ZIP_COMPRESSED",n,`${a} is compressed`),i(20)!==i(24)&&b("ZIP_SIZE",n,`${a} has two sizes`)}function _h(r,e,t){let n=[...r].sort((a,o)=>a.header-o.header),s=0;n.forEach((a,o)=>{a.end=o+1<n.length?n[o+1].header:e,a.extra=a.end-a.header-Tn-a.name.length-a.size,a.extra<0&&b("ZIP_OVERLAP",a.name,"shares bytes with the next entry"),a.header!==s&&b("ZIP_GAP",t,`bytes ${s} to ${a.header} are no entry's`),s=a.end});let i=n[0];i.name!==on&&b("ZIP_ORDER",t,`${on} is not the first entry`),i.size>vo&&b("MANIFEST_TOO_LARGE",on,`${i.size} bytes; at most ${vo}`)}function bo(r,e){let t=Mn(e),{name:n}=r,s=r.name.length;e.length<r.end-r.header&&b("ZIP_TRUNCATED",n,"the file ends within it"),t.getUint32(0,!0)===67324752&&t.getUint16(26,!0)===s&&yo(e.subarray(4,26),r.central.subarray(6,28))&&yo(e.subarray(Tn,Tn+s),r.central.subarray(Ct))||b("ZIP_LOCAL_HEADER",n,"local and central header differ");let a=t.getUint16(28,!0),o=Tn+s;vh(e.subarray(o,o+a),a,n),(r.header+o+a)%go&&b("ZIP_ALIGNMENT",n,`data at byte ${r.header+o+a}, no multiple of ${go}`),a!==r.extra&&b(a>r.extra?"ZIP_OVERLAP":"ZIP_GAP",n,"its data does not end where the next entry starts");let l=e.subarray(o+a,o+a+r.size);return yh(l)!==r.crc&&b("ZIP_CRC",n,"the bytes do not have the CRC-32 of the header"),l}function vh(r,e,t){if(e===0)return;e>=4&&r.length===e&&r[0]===82&&r[1]===78&&r[2]+256*r[3]===e-4&&r.subarray(4).every(s=>s===0)||b("ZIP_EXTRA",t,"the extra field is not zero padding")}var yo=(r,e)=>r.length===e.length&&r.every((t,n)=>t===e[n]),On=Array.from({length:4},()=>new Uint32Array(256));for(let r=0;r<256;r++){let e=r;for(let t=0;t<8;t++)e=e&1?e>>>1^3988292384:e>>>1;On[0][r]=e>>>0}for(let r=1;r<4;r++)for(let e=0;e<256;e++){let t=On[r-1][e];On[r][e]=t>>>8^On[0][t&255]}function yh(r){let[e,t,n,s]=On,i=4294967295,a=0;for(;a+4<=r.length;a+=4)i^=r[a]|r[a+1]<<8|r[a+2]<<16|r[a+3]<<24,i=s[i&255]^n[i>>>8&255]^t[i>>>16&255]^e[i>>>24];for(;a<r.length;a++)i=e[(i^r[a])&255]^i>>>8;return(i^4294967295)>>>0}var xo=2**26,wh=2**25,bh=2**31,xh={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},Ah={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function Or(r,e){let t=dt(r,e,"GEOMETRY_CONTAINER"),{tensors:n}=t,s="steps"in n||"scales"in n,i=s?Ah:xh,a=Object.keys(i);Eh(t,i,a,e);let o=Object.fromEntries(a.map(_=>[_,n[_].shape])),l=vt(r,t,a,e,"GEOMETRY_RANGE"),u=Object.fromEntries(a.map((_,w)=>[_,l[w]])),f=o.offsets[0]-1,p=o.radii[0];(!(s?o.origins[0]===f&&o.steps[0]===p-f&&o.scales[0]===2:o.points[0]===p)||f<1)&&b("GEOMETRY_ARRAY",e,"tensors whose shapes do not fit each other"),Rh(u.offsets,p,e);let g=s?Sh(u,e):u;return kh(g,e),g}function Eh(r,e,t,n){let{tensors:s}=r,i="GEOMETRY_PROFILE",a=Object.keys(s);(a.length!==t.length||t.some(l=>!a.includes(l)))&&b(i,n,`found ${a.join(", ")||"no tensors"}, expected ${t.join(", ")}`),_t(r.metadata)||b(i,n,"__metadata__ is no object");for(let[l,[u,f]]of Object.entries(e)){let p=s[l];gt(p)&&u.includes(p.dtype)&&p.shape.length===f&&(f===1||p.shape[1]===3)||b(i,n,`${l} is not ${u.join(" or ")} of ${f} dimensions`)}((s.points??s.radii).shape[0]>xo||s.radii.shape[0]>xo||s.offsets.shape[0]-1>wh)&&b(i,n,"more points or strands than allowed"),r.data%64&&b(i,n,"data does not start at a multiple of 64")}function Rh(r,e,t){let n=r[0]===0&&r.at(-1)===e;for(let s=1;s<r.length&&n;s++)n=r[s]>=r[s-1]+2;n||b("GEOMETRY_STRANDS",t,"the offsets do not part the points into strands")}function Sh({scales:r,origins:e,offsets:t,steps:n,radii:s},i){let[a,o]=r;a>0&&Number.isFinite(a)||b("GEOMETRY_STEPS",i,"steps without length"),e.some(f=>!Number.isFinite(f))&&b("GEOMETRY_NOT_FINITE",i,"an origin is not finite"),(!(o>0&&Number.isFinite(o))||s.some(f=>f===0))&&b("GEOMETRY_RADIUS",i,"a radius that is not above 0");let l=new Float32Array(3*s.length),u=0;for(let f=0;f+1<t.length;f++){for(let p=0;p<3;p++){let m=e[3*f+p],g=0;l[3*t[f]+p]=m;for(let _=t[f]+1,w=u;_<t[f+1];_++,w++)g+=n[3*w+p],Math.abs(g)>bh&&b("GEOMETRY_STEPS",i,`strand ${f} goes too far`),l[3*_+p]=m+a*g}u+=t[f+1]-t[f]-1}return{points:l,radii:Float32Array.from(s,f=>f*o),offsets:t}}function kh({points:r,radii:e,offsets:t},n){(r.some(s=>!Number.isFinite(s))||e.some(s=>!Number.isFinite(s)))&&b("GEOMETRY_NOT_FINITE",n,"a point or a radius is not finite");for(let s=0;s+1<t.length;s++)for(let i=t[s]+1;i<t[s+1];i++)r[3*i]===r[3*i-3]&&r[3*i+1]===r[3*i-2]&&r[3*i+2]===r[3*i-1]&&b("GEOMETRY_SEGMENT",n,`two equal points in strand ${s}`);e.some(s=>!(s>0))&&b("GEOMETRY_RADIUS",n,"a radius that is not above 0")}var hi=[0,1,-1,1e4,-1e4,34028234663852886e22,-34e37],Nh=5,Ih=34028234663852886e22;function Ao(r,e){let t=1,n=()=>(t=Math.imul(t,1664525)+1013904223|0)/2**31;for(let s=0;s<hi.length+Nh;s++){let i=Float32Array.from({length:r.columns},()=>hi[s]??n()),a=Th(r,i).find(o=>!(o>=0&&o<=Ih));a!==void 0&&b("DECODER_RESULT",e,`a query of ${hi[s]??"random"} numbers gives ${a}, expected finite results, not negative`)}}function Th({low:r,high:e,gain:t,offset:n,layers:s,top:i,unit:a,matrix:o,outputs:l},u){let f=u.map(g=>Math.min(Math.max(g,r),e)),p=t?f.map((g,_)=>g*t[_]+n[_]):f;for(let g of s)p=Oh(g,p);let m=p.map(g=>(Math.exp(Math.min(Math.max(g,0),i))-1)*a);return o?Eo(m,o,l):m}function Oh({weight:r,bias:e,columns:t,step:n,scales:s,relu:i},a){let o=s?a.map(l=>l/n>0?Mh(Math.min(l/n,255)):0):a;return Eo(o,r,t).map((l,u)=>{let f=s?(l+e[u])*n*s[u]:l+e[u];return i?Math.max(f,0):f})}var Mh=r=>r+1.5*2**52-1.5*2**52;function Eo(r,e,t){let n=new Float64Array(t);return r.forEach((s,i)=>{if(s!==0)for(let a=0,o=i*t;a<t;a++,o++)n[a]+=s*e[o]}),Float32Array.from(n)}var Le=1,mi=2,di=3,gi=6,Lh={[Le]:Float32Array,[mi]:Uint8Array,[di]:Int8Array,[gi]:Int32Array},Ro=[3,4,5,6,7,10,11,13],So=2**18;function No(r,{columns:e,outputs:t,output:n},s){let i=new pi(s),a=i.message(r,{1:"number",7:"bytes",8:"many",20:"many",25:"many"}),o=a[8].map(u=>i.message(u,{1:"text",2:"number"})),l=i.message(a[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});return a[1]>=7&&a[1]<=10||s(`IR version ${a[1]}, expected 7 to 10`),(o.length!==1||!Io(o[0][1])||!(o[0][2]>=13&&o[0][2]<=21))&&s("operators that are not those of ONNX, version 13 to 21"),(a[20].length||a[25].length||l[15].length)&&s("functions, training or sparse tensors"),ko(i,l[11],"queries",e),ko(i,l[12],n,t),{nodes:l[1].map(u=>Ph(i,u)),constants:l[5].map(u=>Fh(i,u))}}var Io=r=>r===""||r==="ai.onnx";function ko(r,e,t,n){let[s]=e.map(l=>r.message(l,{1:"text",2:"bytes"})),i=s&&r.message(r.message(s[2],{1:"bytes"})[1],{1:"number",2:"bytes"}),a=i&&r.message(i[2],{1:"many"})[1].map(l=>r.message(l,{1:"number?",2:"text"})[1]);e.length===1&&s[1]===t&&i[1]===Le&&a.length===2&&a[0]===void 0&&a[1]===n||r.outside(`not one ${t}, float32 [N, ${n}]`)}function Ph(r,e){let t=r.message(e,{1:"many",2:"many",4:"text",5:"many",7:"text"});(!Io(t[7])||t[2].length!==1)&&r.outside(`${t[4]} of another domain, or of several results`);let n=t[5].map(s=>r.message(s,{1:"text",3:"number?"}));return(n.some(({1:s,3:i})=>s!=="axis"||i===void 0)||n.length>1)&&r.outside(`${t[4]} with another attribute than axis`),{operator:t[4],inputs:t[1].map(r.text),output:r.text(t[2][0]),axis:n[0]?.[3]??null}}function Fh(r,e){let t=Object.fromEntries(Ro.map(f=>[f,"many"])),n=r.message(e,{1:"numbers",2:"number",8:"text",9:"bytes",14:"number",...t});(n[14]||Ro.some(f=>n[f].length))&&r.outside("a constant not in raw_data");let{1:s,2:i,9:a}=n,o=Lh[i],l=s.reduce((f,p)=>f*p,1),u=o&&s.length<=2&&a.length===l*o.BYTES_PER_ELEMENT;return{name:n[8],type:i,dims:s,values:u?an(o,a,0,l):null}}var pi=class{constructor(e){this.outside=e,this.fields=0,this.text=t=>{try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{return e("a name that is no UTF-8")}}}message(e,t){let n=Object.fromEntries(Object.keys(t).map(s=>[s,[]]));for(let s=0;s<e.length;){++this.fields>So&&this.outside("too many fields");let i,a;[i,s]=this.varint(e,s),i<8&&this.outside("a field without a number"),[a,s]=this.value(e,s,i%8),n[Math.floor(i/8)]?.push(a)}return Object.fromEntries(Object.entries(t).map(([s,i])=>[s,this.taken(n[s],i)]))}taken(e,t){if(t==="numbers")return e.flatMap(s=>typeof s=="number"?s:this.packed(s));let n=t.startsWith("number");return e.some(s=>typeof s=="number"!==n)&&this.outside("a field of another type"),t==="many"?e:(e.length>1&&this.outside("a field twice"),n?e[0]??(t==="number"?0:void 0):t==="text"?this.text(e[0]??new Uint8Array):e[0]??new Uint8Array)}packed(e){let t=[];for(let n=0,s;n<e.length;)++this.fields>So&&this.outside("too many numbers"),[s,n]=this.varint(e,n),t.push(s);return t}value(e,t,n){if(n===0)return this.varint(e,t);let s={1:8,5:4}[n];return n===2&&([s,t]=this.varint(e,t)),(s===void 0||t+s>e.length)&&this.outside("a field that is cut short"),[e.subarray(t,t+s),t+s]}varint(e,t){for(let n=0,s=1,i=0;i<10&&t<e.length;i++,s*=128){let a=e[t++];if(n+=(a&127)*s,a<128)return[n,t]}return this.outside("a number that is cut short")}};var To=64*2**20,Oo=4096,Mo=8192,Lo=2**16,Po=2**24,wt=[Le,[]],Fo=[mi,[]];function Co(r,{columns:e,outputs:t,output:n,precision:s},i){r.length>To&&b("DECODER_TOO_LARGE",i,`${r.length} bytes; at most ${To}`);let a=u=>b("DECODER_PROFILE",i,`not a decoder as the format has it: ${u}`),o=No(r,{columns:e,outputs:t,output:n},a),l=new _i(o,{columns:e,outputs:t,output:n,int8:s==="int8"},i,a).decoder();return Ao(l,i),l}var _i=class{constructor({nodes:e,constants:t},n,s,i){Object.assign(this,n,{where:s,outside:i,width:n.columns,value:"queries",values:n.outputs,work:0}),e.length>Oo&&i(`${e.length} nodes; at most ${Oo}`);let a=["queries",...t.map(({name:o})=>o),...e.map(({output:o})=>o)];(new Set(a).size!==a.length||a.includes(""))&&i("a value made twice, or without a name"),this.constants=new Map(t.map(o=>[o.name,o])),this.unread=new Set(this.constants.keys()),this.dequantizers=new Map,this.nodes=e.values(),this.advance()}advance(){for(;;){if(this.node=this.nodes.next().value,this.node?.operator!=="DequantizeLinear"||!this.constants.has(this.node.inputs[0]))return;this.dequantizers.set(this.node.output,this.node)}}get operator(){return this.node?.operator??"nothing"}next(e,t){let{node:n}=this;return this.operator!==e&&this.outside(`${this.operator} where ${e} must be`),(n.inputs[0]!==this.value||n.inputs.length!==t+1||n.axis!==null)&&this.outside(`${e} of ${n.inputs.join(", ")}, not of ${this.value} and ${t} constants`),this.value=n.output,this.advance(),n.inputs.slice(1)}read(e,t){return e.length!==t.length&&this.outside(`${e.length} constants where ${t.length} must be`),t.map(([n,s],i)=>{let{values:a,...o}=this.constants.get(e[i])??{};return(!a||o.type!==n||o.dims.join()!==s.join())&&this.outside(`${e[i]} is no constant of type ${n} and shape [${s}]`),n===Le&&!a.every(Number.isFinite)&&b("DECODER_RESULT",this.where,`${e[i]} has values that are NaN or infinite`),this.unread.delete(e[i]),a})}take(e,...t){return this.read(this.next(e,t.length),t)}multiply(e,{isLayer:t}){let n=this.constants.get(e)?.dims[1]??0,s=this.width;return n>=1&&n<=Mo||this.outside(`${e} has ${n} columns; from 1 to ${Mo}`),t&&(this.values+=n),this.work+=s*n,(this.values>Lo||this.work>Po)&&b("DECODER_COST",this.where,`${this.values} values and ${this.work} multiply-adds of a query, or more; at most ${Lo} and ${Po}`),this.width=n,{rows:s,columns:n}}decoder(){let e=[Le,[this.columns]],{int8:t,columns:n,outputs:s}=this,[[i],[a]]=this.take("Clip",wt,wt),[o]=t?this.take("Mul",e):[null],[l]=t?this.take("Add",e):[null],u=[];do u.push(t?this.int8Layer():this.layer());while(t?this.operator!=="Clip":u.at(-1).relu);let[[f],[p]]=this.take("Clip",wt,wt);this.take("Exp");let[[m]]=this.take("Sub",wt);(f!==0||m!==1)&&this.outside(`Clip from ${f}, Sub of ${m}`);let g=this.operator==="MatMul"?this.mixing():{unit:this.take("Mul",wt)[0][0],matrix:null};return(this.node||this.dequantizers.size||this.unread.size)&&this.outside("a node or a constant that the chain does not have"),(this.value!==this.output||this.width!==s)&&this.outside(`${this.width} columns of ${this.value} in the end`),{low:i,high:a,gain:o,offset:l,layers:u,top:p,...g,int8:t,columns:n,outputs:s}}mixing(){let e=this.next("MatMul",1),{rows:t,columns:n}=this.multiply(e[0],{isLayer:!1});return{unit:1,matrix:this.read(e,[[Le,[t,n]]])[0]}}layer(){let e=this.next("Gemm",2),{rows:t,columns:n}=this.multiply(e[0],{isLayer:!0}),[s,i]=this.read(e,[[Le,[t,n]],[Le,[n]]]),a=this.operator==="Relu";return a&&this.take("Relu"),{weight:s,bias:i,rows:t,columns:n,relu:a}}int8Layer(){let[[e],[t]]=this.take("QuantizeLinear",wt,Fo),[[n],[s]]=this.take("DequantizeLinear",wt,Fo);(t||s||e!==n)&&this.outside("two scales, or a zero point");let i=new Map(this.dequantizers),[a,o]=this.next("Gemm",2).map((_,w)=>this.dequantized(i,_,1-w)),{rows:l,columns:u}=this.multiply(a[0],{isLayer:!0}),[f,p]=this.read(a,[[di,[l,u]],[Le,[u]]]),[m,g]=this.read(o,[[gi,[u]],[Le,[u]]]);return g.some((_,w)=>_!==Math.fround(e*p[w]))&&this.outside("a bias with a scale of its own"),{weight:f,bias:m,rows:l,columns:u,step:e,scales:p,relu:!1}}dequantized(e,t,n){let s=e.get(t);return(s?.axis!==n||!this.dequantizers.delete(t))&&this.outside(`${t} is no DequantizeLinear of constants along axis ${n}`),s.inputs}};async function zo(r,{elementSize:e,distance:t,size:n},s){let i=await Ch(r,n,s),a=Math.floor(n/e),o=new Uint8Array(n);for(let l=0;l<e;l++){let u=l*a;for(let f=0;f<a;f++)o[f*e+l]=i[u+f]}if(o.set(i.subarray(a*e),a*e),t){let l={1:Uint8Array,2:Uint16Array,4:Uint32Array}[e],u=new l(o.buffer,0,a);for(let f=t;f<a;f++)u[f]+=u[f-t]}return o}async function Ch(r,e,t){let n=new Uint8Array(e),s=0;try{let i=new Blob([r]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:a,value:o}=await i.read();if(a)break;if(s+o.length>e)throw i.cancel().catch(()=>{}),new RangeError(`more than ${e} bytes`);n.set(o,s),s+=o.length}}catch(i){b("DEFLATE_STREAM",t,`no whole zlib stream of ${e} bytes (${i.message})`)}return s!==e&&b("DEFLATE_STREAM",t,`inflates to ${s} bytes, expected ${e}`),n}var Be={$schema:"https://json-schema.org/draft/2020-12/schema",title:"Manifest",$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Albedo:{additionalProperties:!1,description:"Reflected light of a uniform white world, over the reference's; 1 is all of it.",properties:{ratio:{description:"Of rays from all sides.",minimum:0,type:"number"},facing:{default:null,description:"Of those less than 50 degrees from the normal.",minimum:0,type:"number"},at60:{default:null,description:"Of those 50 to 70 degrees from the normal.",minimum:0,type:"number"},at80:{default:null,description:"Of those more than 70 degrees from the normal.",minimum:0,type:"number"}},required:["ratio"],title:"Albedo",type:"object"},BaseColorRecord:{additionalProperties:!1,description:"Triangles with a base colour.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},image:{default:null,description:"Entry with a PNG, JPEG or WebP; white without one.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},colorSpace:{default:null,description:"Of the image; srgb without one.",enum:["srgb","linear"],type:"string"},factor:{default:null,description:"Linear RGB; white without one.",maxItems:3,minItems:3,prefixItems:[{maximum:1,minimum:0,type:"number"},{maximum:1,minimum:0,type:"number"},{maximum:1,minimum:0,type:"number"}],type:"array"},wrap:{default:null,description:"Beyond the image's edges, along u and v; repeat without one.",maxItems:2,minItems:2,prefixItems:[{enum:["repeat","clamp","mirror"],type:"string"},{enum:["repeat","clamp","mirror"],type:"string"}],type:"array"},transform:{default:null,description:"From texture coordinates to the image's: (a, b, c, d, e, f).",maxItems:6,minItems:6,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["triangles"],title:"BaseColorRecord",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"Cost of a query.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder per query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds per query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Trained directions, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"},baseColor:{default:[],description:"Base colour of a surface.",items:{$ref:"#/$defs/BaseColorRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Origin of the asset.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"Emission of a part: a separate decoder on features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierNearby:{additionalProperties:!1,description:"Nearby light that the transport of a part counts linearly.",properties:{lengths:{description:"How far it reaches, metres, ascending.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:1e-18,type:"number"},{maximum:1e18,minimum:1e-18,type:"number"},{maximum:1e18,minimum:1e-18,type:"number"}],type:"array"},visible:{description:"Its mean where the asset does not block the light.",maxItems:3,minItems:3,prefixItems:[{maximum:1,minimum:0,type:"number"},{maximum:1,minimum:0,type:"number"},{maximum:1,minimum:0,type:"number"}],type:"array"},shadowed:{description:"Its mean where the asset blocks the light.",maxItems:3,minItems:3,prefixItems:[{maximum:1,minimum:0,type:"number"},{maximum:1,minimum:0,type:"number"},{maximum:1,minimum:0,type:"number"}],type:"array"}},required:["lengths","visible","shadowed"],title:"TierNearby",type:"object"},TierPart:{additionalProperties:!1,description:"Planes and decoders of one part: of transport, and optionally of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},usesBaseColor:{default:null,description:"Whether transport has a factor of the part's base colour.",type:"boolean"},nearby:{$ref:"#/$defs/TierNearby",default:null},shadowed:{$ref:"#/$defs/TierShadowed",default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TierShadowed:{additionalProperties:!1,description:"Shadowed light of a part, where its decoder of transport gives visible light alone.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierShadowed",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP of the asset's pixels.",minimum:0,type:"number"},flipP95:{default:null,description:"95th percentile of the FLIP of the asset's pixels.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"},albedo:{$ref:"#/$defs/Albedo",default:null,description:"Light returned from a uniform white world."}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}},additionalProperties:!1,description:"manifest.json. `write_package` computes `entries`; leave them out.",properties:{format:{const:"rna",type:"string"},version:{const:"2.0",description:"Version of the format.",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"}},required:["format","version","units","entries","generator","name","parts","domain","tiers","provenance","license"],type:"object"};var zt={type:"number",minimum:0,maximum:1},bt=(r,e=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:r,maximum:e}),ue=r=>({type:"object",properties:r,required:Object.keys(r),additionalProperties:!1}),et=r=>({anyOf:[{type:"null"},r]}),tt=r=>({type:"array",minItems:1,maxItems:16,items:r});var ln=16,Uh=32,{emission:d0,...Uo}=Be.$defs.TierPart.properties,Do={type:"number"},Bo={type:"number",minimum:0},Dh=ue({environment:Be.$defs.Tier.properties.name,psnr:Do,psnrWithLights:Do,flip:Bo,brightness:{type:"array",minItems:3,maxItems:3,items:Bo}}),Ho={$defs:Be.$defs,type:"object",required:["parts"],additionalProperties:!1,properties:{parts:tt(et({type:"object",additionalProperties:!1,required:[...Be.$defs.TierPart.required,"lobes"],properties:{...Uo,lobes:{type:"integer",minimum:2,maximum:Uh},visibility:Uo.planes}})),validation:{type:"array",maxItems:64,items:Dh}}};function Go(r){let e=r.extensions?.RNA_environment?.parts;return e?.every(t=>t)?e:null}function $o({parts:r},e,t){r.some(n=>n)||b("FIELD_VALUE",t,"lobes of no part"),r.forEach((n,s)=>{if(!n)return;let i=`${t}/parts/${s}`;n.lobes%2&&b("FIELD_VALUE",`${i}/lobes`,`found ${n.lobes}, expected an even number`);for(let a of n.inputs)Ft(a).kinds.includes(e.parts[s].kind)||b("INPUT_KIND",`${i}/inputs`,`${a} is not for this part`);for(let a of Mr([n]))Object.hasOwn(e.entries,a)||b("REFERENCE_MISSING",i,`no entry ${a}`)})}var Mr=r=>r.flatMap(({planes:e,decoder:t,visibility:n})=>[e,t,...n?[n]:[]]);function qo(r,e,t){let n="ENVIRONMENT_VISIBILITY",s=dt(r,t,n),i=s.tensors.harmonics;_t(s.metadata)||b(n,t,"__metadata__ is no object"),(Object.keys(s.tensors).join()!=="harmonics"||!gt(i))&&b(n,t,"not one tensor harmonics");let a=[e,ln];return(i.dtype!=="I8"||i.shape.join()!==a.join())&&b(n,t,`found ${i.dtype} [${i.shape}], expected I8 [${a}]`),s.data%64&&b(n,t,"data does not start at a multiple of 64"),vt(r,s,["harmonics"],t,n)[0]}var Bh=16,Yo=3,jo=.99,Vo={surface:["cosine","mirror"],fiber:["forward","cone"]},Ko=(r,e)=>ue({share:zt,width:{type:"number",minimum:r,maximum:e}}),Wo=r=>({type:"array",minItems:1,maxItems:Yo,items:r}),Hh=Ko(1e-4,1),Zo=Ko(.01,4),Xo=ue({parts:tt(et({type:"array",minItems:1,maxItems:Bh,items:{type:"object",additionalProperties:!1,properties:{first:bt(0),cosine:zt,mirror:Wo(Hh),forward:Zo,cone:Wo(Zo)}}}))});function Jo({parts:r},e,t){r.some(n=>n)||b("FIELD_VALUE",t,"lobes of no part"),r.forEach((n,s)=>n?.forEach((i,a)=>{let{kind:o}=e.parts[s],l=`${t}/parts/${s}/${a}`,{first:u=0,...f}=i,p=Object.keys(f).find(_=>!Vo[o].includes(_));p&&b("FIELD_VALUE",`${l}/${p}`,`found ${p}, expected ${Vo[o].join(" and ")} of a ${o}`);let m=el(f,o).lobe_shares.reduce((_,w)=>_+w,0);m>jo&&b("FIELD_VALUE",l,`found shares that add up to ${m}, expected at most ${jo}`),(a===0?u===0:u>(n[a-1].first??0)&&o==="surface")||b("FIELD_VALUE",`${l}/first`,`found ${u}, expected 0, then each above the one before`)}))}function Qo({parts:r,extensions:e},t){let n=e?.RNA_sampling?.parts[t],{kind:s}=r[t];return n?.map(({first:i=0,...a})=>({first:i,lobes:el(a,s)}))??[{first:0,lobes:ra[s]}]}function el({cosine:r=0,mirror:e=[],forward:t={share:0,width:1},cone:n=[]},s){let i=s==="fiber"?[t,...n]:[{share:r,width:1},...e];for(;i.length<1+Yo;)i.push({share:0,width:1});return{lobe_shares:i.map(({share:a})=>a),lobe_widths:i.map(({width:a})=>a)}}var cn={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},{triangles:k0,...Gh}=Be.$defs.BaseColorRecord.properties,$h={type:"array",minItems:1,maxItems:64,items:et({type:"object",properties:Gh,additionalProperties:!1})},tl=2**32-2,qh=2**20,jh=64,nl={RNA_deflate:ue({entries:{type:"object",propertyNames:cn,additionalProperties:ue({elementSize:{enum:[1,2,4]},distance:bt(0),size:bt(0,tl),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:ue({image:cn,width:bt(1),height:bt(1)}),RNA_standin:ue({parts:tt(ue({baseColor:{type:"array",items:zt,minItems:3,maxItems:3},roughness:zt,metallic:zt}))}),RNA_standin_textures:ue({parts:tt(et(ue({baseColor:cn,metallicRoughness:cn,normal:cn})))}),RNA_proxy:ue({parts:tt(et({type:"array",minItems:1,maxItems:8,items:ue({geometry:cn,height:bt(1)})}))}),RNA_variants:{$defs:Be.$defs,...ue({variants:{type:"array",minItems:1,maxItems:64,items:ue({name:{type:"string",minLength:1},parts:tt(et($h))})}})},RNA_environment:Ho,RNA_sampling:Xo},vi=({extensions:r})=>r?.RNA_variants?.variants??[],Lr=Object.keys(nl);function rl(r){let e=r.extensions??{};for(let t of Lr){let n=`/extensions/${t}`;if(!Object.hasOwn(e,t)){r.extensionsUsed?.includes(t)&&b("FIELD_MISSING",n,"its data is missing");continue}sn(nl[t],e[t],n),Vh[t](e[t],r,n)}}function Ln(r,e,t){Object.hasOwn(r.entries,e)||b("REFERENCE_MISSING",t,`no entry ${e}`)}function un(r,e,t){r.length!==e.parts.length&&b("PARTS_DIFFER",t,`found ${r.length} parts, expected ${e.parts.length}`)}var Vh={RNA_deflate({entries:r},e,t){e.extensionsRequired?.includes("RNA_deflate")||b("EXTENSION_UNDECLARED",t,"RNA_deflate is not in extensionsRequired");let n=Object.values(r).reduce((s,{size:i})=>s+i,0);n>tl&&b("FIELD_VALUE",t,`${n} decoded bytes`);for(let[s,{size:i}]of Object.entries(r)){Ln(e,s,t);let a=qh+jh*e.entries[s].size;i>a&&b("DEFLATE_SIZE",`${t}/entries/${s}/size`,`${i} decoded bytes; at most ${a}`)}},RNA_poster({image:r},e,t){Ln(e,r,t)},RNA_standin({parts:r},e,t){un(r,e,t)},RNA_standin_textures({parts:r},e,t){un(r,e,t),r.some(n=>n)||b("FIELD_VALUE",t,"textures of no part"),r.forEach((n,s)=>{let{kind:i,transmittance:a,normalMaps:o}=e.parts[s];n&&(i!=="surface"||a||o)&&b("FIELD_VALUE",t,"textures of a part that has none");for(let l of Object.values(n??{}))Ln(e,l,t)})},RNA_proxy({parts:r},e,t){un(r,e,t),r.some(n=>n)||b("FIELD_VALUE",t,"a proxy of no part"),r.forEach((n,s)=>{let{transmittance:i,normalMaps:a,baseColor:o}=e.parts[s];n&&(i||a||o)&&b("FIELD_VALUE",t,"a proxy of a part with textures"),(n??[]).forEach(({geometry:l,height:u},f)=>{Ln(e,l,t),f&&u>=n[f-1].height&&b("FIELD_VALUE",t,"heights must descend")})})},RNA_variants({variants:r},e,t){new Set(r.map(({name:n})=>n)).size<r.length&&b("FIELD_VALUE",t,"two variants of one name");for(let{name:n,parts:s}of r)un(s,e,t),s.forEach((i,a)=>{let o=e.parts[a].baseColor?.length??0;i&&i.length!==o&&b("FIELD_VALUE",t,`${n}: ${i.length} records, expected ${o}`);for(let l of i??[])l?.image!==void 0&&Ln(e,l.image,t)})},RNA_environment(r,e,t){un(r.parts,e,t),$o(r,e,t)},RNA_sampling(r,e,t){un(r.parts,e,t),Jo(r,e,t)}};var wi="RNA_relightable_asset",sl="model/vnd.rna",il=64,al=2**23,yi=12,Pn=8,Wh=1179937895,Zh=1313821514,ol=5130562;async function ll(r){let{size:e,name:t}=r,n=A=>b("GLB_CONTAINER",t,A),s=async(A,T)=>new Uint32Array((await r.read(A,A+4*T)).slice().buffer);if(e<yi+Pn)return r;let[i,a,o,l,u]=await s(0,5),f=yi+Pn+l;if(i!==Wh||a!==2)return r;(u!==Zh||f>e)&&n(`expected a JSON chunk that ends within the file's ${e} bytes, found a chunk to byte ${f}`),l>al&&n(`JSON of ${l} bytes; at most ${al}`);let p=await r.read(yi+Pn,f);if(!new TextDecoder().decode(p).includes(`"${wi}"`))return r;o!==e&&n(`expected the ${o} bytes that the header says, found ${e}`);let[m,g]=f+Pn<=e?await s(f,2):[0,ol],_=f+Pn;f<e&&(g!==ol||_+m>e)&&n(`expected a BIN chunk at byte ${f}, found another, or one that ends behind the file`);let w=[...Yh(ht(p,t,"GLB_CONTAINER"),{start:_,length:m},t).values()];return w.length>1&&b("GLB_SEVERAL",t,`expected one package, found ${w.length}: RNAExtension of rna-three shows scenes of several`),w.length?r.part(...w[0]):r}function Yh(r,e,t){let n=Array.isArray(r.nodes)?r.nodes:[],s=new Map;return n.forEach((i,a)=>{let o=i?.extensions?.[wi];if(o==null)return;let l=`${t}: /nodes/${a}/extensions/${wi}`;o?.mimeType!==sl&&b("GLB_PACKAGE",`${l}/mimeType`,`expected "${sl}", found ${JSON.stringify(o?.mimeType)}`),bi(o.package)||b("GLB_PACKAGE",`${l}/package`,`expected the index of a buffer view, found ${JSON.stringify(o.package)}`),s.set(o.package,Kh(r,o.package,e,`${t}: /bufferViews/${o.package}`))}),s}function Kh({bufferViews:r,buffers:e},t,n,s){let i=r?.[t],{buffer:a,byteOffset:o=0,byteLength:l}=i??{},u=n.start+o;return i||b("GLB_PACKAGE",s,"no such buffer view"),(a!==0||!e?.[0]||"uri"in e[0])&&b("GLB_PACKAGE",s,"expected a view of the BIN chunk, buffer 0"),(!bi(o)||!bi(l)||!l||o+l>n.length)&&b("GLB_PACKAGE",s,`${l} bytes at ${o} of ${n.length}`),u%il&&b("GLB_ALIGNMENT",s,`begins at byte ${u} of the file, no multiple of ${il}`),[u,u+l]}var bi=r=>Number.isSafeInteger(r)&&r>=0;var xi="2.0",cl=[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"],["baseColor","BASE_COLOR_RANGE"]],Xh=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;function ul(r){let e=ht(r,"manifest.json","MANIFEST_NOT_JSON");Jh(e),sn(Be,e),Qh(e),ep(e),tp(e),np(e),rl(e),rp(e),sp(e),ap(e);let t=(e.extensionsUsed??[]).filter(n=>!Lr.includes(n));return{...e,warnings:t.map(n=>`unknown extension ${n}`)}}function Jh(r){r.format!=="rna"&&b("FORMAT_UNKNOWN","/format","this is no RNA package");let{version:e}=r;if(typeof e=="string"&&Xh.test(e)&&e!==xi){let t=parseInt(e,10)<parseInt(xi,10)?"VERSION_TOO_OLD":"VERSION_TOO_NEW";b(t,"/version",`the package is of version ${e}; this viewer reads ${xi}`)}for(let t of Array.isArray(r.parts)?r.parts:[])t?.kind!==void 0&&!["surface","fiber"].includes(t.kind)&&b("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(t.kind)}, expected surface or fiber`);for(let t of Array.isArray(r.extensionsRequired)?r.extensionsRequired:[])typeof t=="string"&&!Lr.includes(t)&&b("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${t}`)}function Qh(r){r.parts.forEach(({bounds:{min:e,max:t}},n)=>{e.forEach((s,i)=>{Math.fround(t[i])-Math.fround(s)>=1e-18||b("BOUNDS_EMPTY",`/parts/${n}/bounds`,`no extent along axis ${i}`)})});for(let e of["wo","wi"]){let t=r.domain[e];for(let{axis:n}of Array.isArray(t)?t:[])Math.abs(Math.hypot(...n)-1)>.001&&b("FIELD_VALUE",`/domain/${e}`,"an axis is no unit vector")}}function ep(r){for(let[e,t]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let n=r[e].map(({name:s})=>s);new Set(n).size!==n.length&&b(t,`/${e}`,"a name is there twice")}r.tiers.forEach(({validation:e,parts:t},n)=>{t.forEach(({nearby:s},i)=>{s?.lengths.some((a,o,l)=>o&&a<=l[o-1])&&b("FIELD_VALUE",`/tiers/${n}/parts/${i}/nearby/lengths`,"lengths must ascend")}),(e?.flipAtHeight??[]).forEach(({height:s},i,a)=>{i&&s>=a[i-1].height&&b("FIELD_VALUE",`/tiers/${n}/validation/flipAtHeight/${i}`,"heights must descend")})})}function tp(r){r.tiers.forEach((e,t)=>{e.parts.length!==r.parts.length&&b("PARTS_DIFFER",`/tiers/${t}/parts`,`found ${e.parts.length}, expected ${r.parts.length}`),e.parts.forEach((n,s)=>{!n.emission!=!r.tiers[0].parts[s].emission&&b("PARTS_DIFFER",`/tiers/${t}/parts/${s}`,"emission in some tiers alone"),n.usesBaseColor&&!r.parts[s].baseColor&&b("FIELD_VALUE",`/tiers/${t}/parts/${s}/usesBaseColor`,`found true, expected false, or baseColor in /parts/${s}`)})})}function np(r){let e=r.extensionsUsed??[];for(let t of[...Object.keys(r.extensions??{}),...r.extensionsRequired??[]])e.includes(t)||b("EXTENSION_UNDECLARED","/extensionsUsed",`${t} is not there`)}function rp(r){r.tiers.forEach((e,t)=>e.parts.forEach((n,s)=>{let{kind:i}=r.parts[s],a=(o,l)=>{for(let u of o)l(Ft(u))||b("INPUT_KIND",`/tiers/${t}/parts/${s}/inputs`,`${u} is not for this part`)};a(n.inputs,({kinds:o})=>o.includes(i)),a(n.shadowed?.inputs??[],({kinds:o})=>o.includes(i)),a(n.emission?.inputs??[],({kinds:o,light:l})=>o.includes(i)&&!l)}))}function sp(r){r.parts.forEach((e,t)=>{for(let[n,s]of cl){let i=`/parts/${t}/${n}`;e[n]&&e.kind!=="surface"&&b("FIELD_VALUE",i,`of a ${e.kind}`);let a=0;(e[n]??[]).forEach(({triangles:[o,l]},u)=>{o<a&&b(s,`${i}/${u}`,"ranges must ascend and not overlap"),a=o+l})}})}function*ip(r){for(let[e,t]of r.parts.entries()){yield[`/parts/${e}/geometry`,t.geometry];for(let[n]of cl)for(let[s,{texture:i,image:a}]of(t[n]??[]).entries())(i??a)&&(yield[`/parts/${e}/${n}/${s}`,i??a])}for(let[e,t]of r.tiers.entries())for(let[n,s]of t.parts.entries()){let i=`/tiers/${e}/parts/${n}`;yield[`${i}/planes`,s.planes],yield[`${i}/decoder`,s.decoder];for(let a of["shadowed","emission"])s[a]&&(yield[`${i}/${a}/decoder`,s[a].decoder])}}function ap(r){let e=new Set;for(let[n,s]of ip(r))Object.hasOwn(r.entries,s)||b("REFERENCE_MISSING",n,`no entry ${s}`),e.add(s);let t=(r.extensionsUsed??[]).map(n=>`extensions/${n}/`);for(let n of Object.keys(r.entries))!e.has(n)&&!t.some(s=>n.startsWith(s))&&b("ENTRY_UNREFERENCED","/entries",`nothing refers to ${n}`)}function fl(r,e){for(let t of e.keys())t!=="manifest.json"&&!Object.hasOwn(r.entries,t)&&b("ENTRY_UNDECLARED","/entries",`the archive holds ${t}`);for(let[t,{size:n}]of Object.entries(r.entries)){let s=e.get(t);(!s||t==="manifest.json")&&b("ENTRY_MISSING","/entries",`the archive lacks ${t}`),s.size!==n&&b("ENTRY_SIZE",`/entries/${t}`,`found ${s.size}, expected ${n}`)}}var op={float16:"F16",float32:"F32",int8:"I8"},Ai=1e18;function Ei(r,{planePrecision:e,resolution:t,channels:n},s){let i=dt(r,s,"PLANES_HEADER"),{tensors:a}=i,o=e==="int8",l=o?{scales:["F32",[3,n]],planes:["I8",[3,t,t,n]]}:{planes:[op[e],[3,t,t,n]]},u=Object.keys(l),f=Object.keys(a);_t(i.metadata)||b("PLANES_TENSOR",s,"__metadata__ is no object"),(f.length!==u.length||u.some(_=>!f.includes(_)))&&b("PLANES_TENSOR",s,`found ${f.join(", ")||"no tensors"}, expected ${u.join(", ")}`);for(let _ of u)kr(a[_])||b("PLANES_TENSOR",s,`${_} is no object`);for(let _ of u){let[w,A]=l[_],T=a[_];T.dtype!==w&&b("PLANES_DTYPE",s,`${_}: found ${T.dtype}, expected ${w}`),(!gt(T)||T.shape.join()!==A.join())&&b("PLANES_SHAPE",s,`${_}: found [${T.shape}], expected [${A}]`)}let p=vt(r,i,u,s,"PLANES_HEADER");i.data%64&&b("PLANES_ALIGNMENT",s,"data does not start at a multiple of 64");let m=p.at(-1),g=o?p[0]:null;return lp(e,m,g,s),{values:m,scales:g,resolution:t,channels:n,precision:e}}function lp(r,e,t,n){let s=()=>b("PLANES_NOT_FINITE",n,`NaN, or a value beyond ${Ai}`);if(r==="int8")t.some(i=>!(Math.abs(i)*128<=Ai))&&s();else if(r==="float16")for(let i=0;i<e.length;i++)(e[i]&31744)===31744&&s();else for(let i=0;i<e.length;i++)Math.abs(e[i])<=Ai||s()}var cp=8192;function hl(r,e,t,n,s){let i=dt(r,n,s),a=i.tensors[e];_t(i.metadata)||b(s,n,"__metadata__ is no object"),(Object.keys(i.tensors).join()!==e||!gt(a))&&b(s,n,`not one tensor ${e}`);let[o,l,u]=a.shape,f=a.shape.length===3&&[o,l].every(m=>m>=1&&m<=cp);(a.dtype!=="U8"||!f||!t.includes(u))&&b(s,n,`found ${a.dtype} [${a.shape}], expected U8 [H, W, ${t.join(" or ")}]`),i.data%64&&b(s,n,"data does not start at a multiple of 64");let[p]=vt(r,i,[e],n,s);return{values:p,height:o,width:l,channels:u}}function Pr(r,e,t){let n="TRANSMITTANCE_TEXTURE",s=hl(r,"transmittance",[1,3],t,n);return e.cutoff!==void 0&&s.channels!==1&&b(n,t,"a cutoff of a coloured texture"),s}function Fr(r,e){return hl(r,"normals",[2],e,"NORMAL_MAP_TEXTURE")}function Cr({triangles:[r,e]},t,n,s,i){r+e>n.indices.length/3&&b(`${i}_RANGE`,s,`triangles ${r} to ${r+e} of ${n.indices.length/3}`),t&&(i!=="TRANSMITTANCE"||t.width*t.height>1)&&!n.uvs&&b(`${i}_UV`,s,"the mesh has no texture coordinates")}var up=65536,fn=class r{static async open(e){let t=new r;return t.source=await ll(e),t.directory=await wo(t.source),t.cache=new Map,t.images=new Map,t.manifest=ul(await t._stored(on)),fl(t.manifest,t.directory),t.environment=Go(t.manifest),t}get poster(){return this.manifest.extensions?.RNA_poster}tier(e){let t=e?this.manifest.tiers.find(n=>n.name===e):this.manifest.tiers[0];if(!t){let n=this.manifest.tiers.map(s=>s.name).join(", ");b("TIER_UNKNOWN",this.source.name,`no tier ${e}; there are ${n}`)}return t}bytesOf(e){return this._ranges(this._needed(e,!0)).reduce((t,[n,s])=>t+s-n,0)}prefetch(e,t){this._fetch([...this.poster?[this.poster.image]:[],...this._needed(e,t)])}async load(e,{wantsLobes:t=!1}={}){let n=this.tier(e),s=this._entriesOf(n),i=new Map;this._fetch(this._needed(e,t));for(let o of s)i.set(o,await this._data(o));await this._readImages(i);let a=this.manifest.parts.map((o,l)=>this._part(o,n.parts[l],l,i));return t&&this.environment&&await this._addEnvironment(a,n,i),{name:n.name,tier:n,parts:a}}async read(e){return this._fetch([...new Set([...e,...this._images()])]),new Map(await Promise.all(e.map(async t=>[t,await this._data(t)])))}get variants(){return vi(this.manifest).map(({name:e})=>e)}async prints(e){let t=new Map;return await this._readImages(t),e.map(({mesh:n},s)=>this._print(s,t,n))}async _addEnvironment(e,t,n){let s=Mr(this.environment).filter(i=>!n.has(i));for(let i of s)n.set(i,await this._data(i));this.environment.forEach((i,a)=>{e[a].environment=this._environment(e[a],i,t.parts[a],n)})}_environment(e,t,n,s){let{inputs:i,lobes:a,visibility:o}=t,l=(e.mesh?.positions??e.curves.points).length/3,f=["planes","resolution","channels","planePrecision"].every(g=>t[g]===n[g])?e.planes:Ei(s.get(t.planes),t,t.planes),p=o?qo(s.get(o),l,o):null,m=o?ln:0;return{inputs:i,lobes:a,harmonics:p,planes:f,...Ri(s,t,t,"environment",9*a,m)}}async posterImage(){return this.poster?(this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear(),this.images.clear()}_part(e,t,n,s){let{kind:i,bounds:a,geometry:o}=e,l=`/parts/${n}`,u=s.get(o),f={name:e.name,kind:i,bounds:hp(a),inputs:t.inputs,sampling:Qo(this.manifest,n),lengths:t.nearby?.lengths};return i==="surface"?f.mesh=Nr(u,o):f.curves=Or(u,o),f.transmittance=(e.transmittance??[]).map(p=>{let m=Pr(s.get(p.texture),p,p.texture);return Cr(p,m,f.mesh,l,"TRANSMITTANCE"),{...p,texture:m}}),f.normalMaps=(e.normalMaps??[]).map(p=>{let m=Fr(s.get(p.texture),p.texture);return Cr(p,m,f.mesh,l,"NORMAL_MAP"),{...p,texture:m}}),f.baseColor=this._print(n,s,f.mesh),f.planes=Ei(s.get(t.planes),t,t.planes),f.decoders=this._decoders(t,s),f}_decoders(e,t){let{nearby:n,usesBaseColor:s,shadowed:i,emission:a}=e,o=(l,u,f)=>{let p=f.length,m=3*p,g=m*(s?2:1),_=Ri(t,e,l,u,n?4*g:g),w=s?m:0,A=n&&{nearbyColumns:g,means:f.flatMap(T=>[...n[T],0])};return{..._,...A,inputs:l.inputs,colours:p,factors:w}};return{...i?{visible:o(e,"visible",["visible"]),shadowed:o(i,"shadowed",["shadowed"])}:{transport:o(e,"transport",["visible","shadowed"])},...a&&{emission:{...Ri(t,e,a,"emission",3),inputs:a.inputs,colours:1}}}}_print(e,t,n){let s=this.manifest.parts[e].baseColor??[];return this._records(e).map((i,a)=>{let o=i.image===void 0?null:t.get(i.image);return Cr(i,o,n,`/parts/${e}`,"BASE_COLOR"),{...i,image:o,label:o&&fp(s[a].image??i.image)}})}_records(e){let t=vi(this.manifest).find(({name:n})=>n===this.variant)?.parts[e];return(this.manifest.parts[e].baseColor??[]).map((n,s)=>t?.[s]?{...t[s],triangles:n.triangles}:n)}_images(){let e=this.manifest.parts.flatMap((t,n)=>this._records(n).map(({image:s})=>s));return new Set(e.filter(t=>t!==void 0))}async _readImages(e){for(let t of this._images())this.images.has(t)||this.images.set(t,await Aa(e.get(t)??await this._data(t),t)),e.set(t,this.images.get(t))}_entriesOf(e){let t=[...this._images()];for(let n of this.manifest.parts){t.push(n.geometry);for(let s of[...n.transmittance??[],...n.normalMaps??[]])t.push(s.texture)}for(let n of e.parts){t.push(n.planes,n.decoder);for(let s of[n.shadowed,n.emission])s&&t.push(s.decoder)}return[...new Set(t)]}_needed(e,t){return[...new Set([...this._entriesOf(this.tier(e)),...Mr(t&&this.environment||[])])]}_ranges(e){let t=e.map(s=>this.directory.get(s)).sort((s,i)=>s.header-i.header),n=[];for(let{header:s,end:i}of t){let a=n.at(-1);a&&s-a[1]<=up?a[1]=i:n.push([s,i])}return n}_fetch(e){let t=e.filter(s=>!this.cache.has(s)),n=this._ranges(t);if(t.length){this.source.expect(n);for(let[s,i]of n){let a=this.source.read(s,i),o=u=>u.header>=s&&u.end<=i,l=t.filter(u=>o(this.directory.get(u)));for(let u of l)this.cache.set(u,{bytes:a,start:s});a.catch(()=>l.forEach(u=>this.cache.delete(u)))}}}async _stored(e){let t=this.directory.get(e),{bytes:n,start:s}=this.cache.get(e)??{},i=n?(await n).subarray(t.header-s,t.end-s):await this.source.read(t.header,t.end);return bo(t,i)}async _data(e){let t=await this._stored(e);await pl(t,this.manifest.entries[e].sha256,e);let n=this.manifest.extensions?.RNA_deflate?.entries[e];if(!n)return t;let s=await zo(t,n,e);return await pl(s,n.sha256,e),s}},fp=r=>r.split("/").pop().replace(/\.[^.]*$/,"");function Ri(r,e,t,n,s,i=0){let o={columns:t.inputs.reduce((l,u)=>l+Tr(u,e.channels),i),outputs:s,output:n,precision:t.decoderPrecision};return Co(r.get(t.decoder),o,t.decoder)}function hp({min:r,max:e}){return{min:r.map(Math.fround),max:e.map(Math.fround)}}async function pl(r,e,t){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",r))].map(i=>i.toString(16).padStart(2,"0")).join("")!==e&&b("ENTRY_HASH",t,"the bytes do not have the declared SHA-256")}var Si=({azimuth:r,elevation:e,distance:t,target:n,fov:s})=>({azimuth:r,elevation:e,distance:t,target:n,fov:s}),ml=(r,e,t)=>Array.isArray(r)?r.map((n,s)=>ml(n,e[s],t)):r+t*(e-r),zr=class{#e;constructor(e){this.#e=e,this.goal=null,e.addEventListener("shown",()=>this._next())}to(e,t){let{orbit:n}=this.#e,s=Si(n);this.stop(),e();let i=Si(n),a=JSON.stringify(s)===JSON.stringify(i);if(!(t>0)||a)return;let o=Math.round((i.azimuth-s.azimuth)/(2*Math.PI));Object.assign(n,s,{azimuth:s.azimuth+2*Math.PI*o}),Object.assign(this,{goal:i,left:1,decay:t,last:performance.now()}),this.#e.restart(!0)}stop(){this.goal=null}_next(){!this.goal||this.isRequested||(this.isRequested=!0,requestAnimationFrame(e=>{this.isRequested=!1,this.goal&&this._step(Math.min(100,Math.max(0,e-this.last))),this.last=e}))}_step(e){let{orbit:t}=this.#e,{goal:n}=this,s=1-Math.exp(-e/(2*this.decay));this.left*=1-s;let i=this.left<.001,a=Si(t);Object.assign(t,i?n:Object.fromEntries(Object.keys(n).map(o=>[o,ml(a[o],n[o],s)]))),i&&this.stop(),this.#e.restart(!i)}};var pp=["maxStorageBufferBindingSize","maxBufferSize"];async function dl(){let r=await navigator.gpu?.requestAdapter({powerPreference:"high-performance"});if(!r){let t=navigator.gpu?"WebGPU has no adapter here":isSecureContext?"this browser has no WebGPU":"WebGPU needs HTTPS, or a page from this machine";throw new $(`${t}: no more than a stand-in or a poster is shown`)}let e=Object.fromEntries(pp.map(t=>[t,r.limits[t]]));return r.requestDevice({requiredLimits:e})}function se(r,e,t=GPUBufferUsage.STORAGE,n="a buffer"){let s=typeof e=="number"?e:e.byteLength,i=Math.max(16,Math.ceil(s/16)*16),a=r.limits.maxStorageBufferBindingSize;if(i>a)throw new $(`${n} takes ${It(i)}; this GPU allows ${It(a)}`);let o=r.createBuffer({size:i,usage:t|GPUBufferUsage.COPY_DST|GPUBufferUsage.COPY_SRC,mappedAtCreation:typeof e!="number"});if(typeof e!="number"){let l=new Uint8Array(e.buffer,e.byteOffset,e.byteLength);new Uint8Array(o.getMappedRange()).set(l),o.unmap()}return o}async function Ur(r,e){let t=r.createShaderModule({code:e}),{messages:n}=await t.getCompilationInfo(),s=n.find(({type:i})=>i==="error");if(s)throw new Error(`a shader does not compile, line ${s.lineNum}: ${s.message}`);return t}var Fn=(r,e,t,n)=>He(r,e.getBindGroupLayout(t),n);function Pe(r,e){let t=Object.entries(e).map(([n,s])=>({binding:Number(n),visibility:GPUShaderStage.COMPUTE,buffer:{type:s}}));return r.createBindGroupLayout({entries:t})}function He(r,e,t){let n=Object.entries(t).map(([s,i])=>({binding:Number(s),resource:{buffer:i}}));return r.createBindGroup({layout:e,entries:n})}function ge(r,e,t,n){let s=Math.max(1,Math.ceil(n/64)),i=Math.min(s,32768);r.setPipeline(e),t.forEach((a,o)=>r.setBindGroup(o,a)),r.dispatchWorkgroups(i,Math.ceil(s/i))}async function Cn(r,e,t){let n=r.createBuffer({size:Math.ceil(t/4)*4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST}),s=r.createCommandEncoder();s.copyBufferToBuffer(e,0,n,0,n.size),r.queue.submit([s.finish()]),await n.mapAsync(GPUMapMode.READ);let i=n.getMappedRange().slice(0);return n.destroy(),i}var mp={position:[0,0,0],corner:[0,0,0],stepX:[0,0,0],stepY:[0,0,0]},Ut=ie.RnaRow.words;async function gl(r,e,t,n,s=!0){let{[t]:i,visible:a,shadowed:o}=r.parts[e],{device:l,queue:u,bandPixels:f}=r,p=i?[i]:[a,o],m=t==="transport"?2:1,g=m/p.length,_=n.length/Ut,w=new Float32Array(3*m*_);for(let A=0;A<_;A+=f){let T=Math.min(f,_-A);l.queue.writeBuffer(u.rows,0,n,Ut*A,Ut*T),l.queue.writeBuffer(u.count,0,Uint32Array.of(T));for(let[F,G]of p.entries()){if(r._run(le=>G.run(le,u,T)),await r.done(),!s)continue;let te=new Float32Array(await Cn(l,u.answers,16*m*T));for(let le=0;le<g*T;le++){let we=Math.floor(le/g),ne=m*we+le%g;w.set(te.subarray(4*ne,4*ne+3),3*(m*A+ne+F))}}}return w}async function _l(r,e,t,n){let{device:s,band:i}=r,{words:a,members:o}=ie.Pixel,l=new Uint32Array(a*e.length);e.forEach(({place:f,b1:p,b2:m,x:g,wi:_,level:w,part:A},T)=>{let F=(G,te)=>[...new Uint32Array(Float32Array.from(G).buffer),te];l.set(pe("Pixel",{position:F(g,0),axis:[0,0,0,A+1],wo:[0,0,0,f],wi:F(_,0),b1:p,b2:m,coverage:w}),a*T)}),r.resize(e.length,1),r.span={first:0,pixels:e.length,jitter:0},s.queue.writeBuffer(i,0,l),r._writeFrame(mp,0,e.length),r._writeView({kind:"given",colour:[1,1,1]}),r._run(f=>ge(f,t,r.groups.rays,e.length));let u=new Float32Array(await Cn(s,i,l.byteLength));return Float32Array.from({length:3*e.length},(f,p)=>u[a*Math.floor(p/3)+o[n].at+p%3])}var vl=(r,e)=>_l(r,e,r.kernels.light,"visibility"),yl=(r,e)=>async(t,n)=>_l(t,n,await t.pipelines.get(t.raySources.hit,r,t.rayLayout),e),wl=yl("find_normals","axis"),bl=yl("find_base_colors","base_color");var ki=r=>Uint8Array.from(atob(r),e=>e.charCodeAt(0));function Dr(r){let e=new Uint8Array(r.buffer,r.byteOffset,r.byteLength),t="";for(let n=0;n<e.length;n+=8192)t+=String.fromCharCode(...e.subarray(n,n+8192));return btoa(t)}var Br=class{rowWords=Ut;constructor(e){this.engine=e}async load(e,t){let n=await fn.open(new Wt(new Blob([ki(e)]),"package"));this.shown=await n.load(t),this.arrays=await wr(this.shown.parts),await this.engine.setAsset(this.arrays,this.shown),this.engine.resize(1,1)}async evaluate(e,t,n,s=16){let i=new Float32Array(ki(n).buffer),a=i.length/s,o=new Float32Array(Ut*a);for(let l=0;l<a;l++){let u=i.subarray(s*l,s*(l+1)),f=u.subarray(7,10),p=s>10?u.subarray(10,13):f,[m=0,g=0,_=0,...w]=u.subarray(13),A=w.length?[...w,1]:[];o.set([...u.subarray(0,3),u[6],...u.subarray(3,6),m,...f,g,...p,_,...A],Ut*l)}return Dr(await this.answer(e,t,o))}answer(...e){return gl(this.engine,...e)}async visibility(e){return Dr(await vl(this.engine,this._hits(e)))}async normals(e){return Dr(await wl(this.engine,this._hits(e)))}async baseColor(e){return Dr(await bl(this.engine,this._hits(e)))}_hits(e){let{buffer:t}=ki(e),n=new Uint32Array(t),s=new Float32Array(t),i=[];for(let a=0;a<n.length;a+=8){let o=n[a+7],{first:l,fiber:u}=this.arrays.parts[o],f=s.subarray(a,a+7),p=this.arrays.where[l+n[a]];i.push(u?{place:p,part:o,b1:0,b2:0,x:f.slice(1,4),wi:f.slice(4,7),level:0}:{place:p,part:o,b1:f[1],b2:f[2],x:[0,0,0],wi:f.slice(3,6),level:f[3]})}return i}};var Hr=.4*Math.PI/180,hn=5*Math.PI/180,Gr=.05,Al=8,dp=250,gp={"pan-y":(r,e)=>Math.abs(e)>Math.abs(r),"pan-x":(r,e)=>Math.abs(r)>Math.abs(e)},Ni={orbit:(r,e,t)=>r.orbit(-e*Hr,t*Hr,!0),light:(r,e,t)=>r.light(e*Hr,-t*Hr,!0),three:(r,e,t)=>Ni.light(r,e/3,t/3),pan:(r,e,t,{height:n})=>r.pan(-e/n,t/n,!0),pinch(r,e,t,{before:n,now:s,other:i,height:a}){r.zoom($r(n,i)/$r(s,i),!0),Ni.pan(r,e/2,t/2,{height:a})},twist:(r,e,t,{before:n,now:s,other:i})=>r.light(-Rl(n,s,i),0,!0)};function El(r,e,t=()=>!0,n=void 0){let s=(i,a)=>r.addEventListener(i,o=>t(o)&&a(o));_p(r,e,t),bp(r,e,t,n),s("contextmenu",i=>i.preventDefault()),s("dblclick",()=>e.reset()),s("keydown",i=>Ap(i,e))}function _p(r,e,t){let n=new Map,s=null,i=new Map,a=null,o=()=>{n.clear(),r.classList.remove("dragging"),e.settle()};r.addEventListener("pointerdown",l=>{t(l)&&(n.size||(a=e.remember?.()),n.set(l.pointerId,xl(l)),xp(r,l.pointerId),r.classList.add("dragging"),i=new Map(n),s=n.size>2?"three":n.size===1&&l.pointerType==="mouse"?vp(l):null)}),r.addEventListener("pointermove",l=>{let u=n.get(l.pointerId),f=xl(l);if(!u)return;n.set(l.pointerId,f);let[p]=[...n].filter(([_])=>_!==l.pointerId).map(([,_])=>_),m=f.x-u.x,g=f.y-u.y;s===null?s=n.size>1?wp(i,n):yp(i,n,r):(m||g)&&Ni[s]?.(e,m,g,{before:u,now:f,other:p,height:r.clientHeight})}),r.addEventListener("pointerup",l=>{n.delete(l.pointerId)&&(s="ended",n.size||o())}),r.addEventListener("pointercancel",l=>{n.has(l.pointerId)&&(a?.(),o())})}var xl=({clientX:r,clientY:e})=>({x:r,y:e}),$r=(r,e)=>Math.hypot(r.x-e.x,r.y-e.y)||1;function Rl(r,e,t){let n=i=>Math.atan2(i.y-t.y,i.x-t.x),s=n(e)-n(r);return Math.atan2(Math.sin(s),Math.cos(s))}function vp({button:r,altKey:e,shiftKey:t}){return r===2?"pan":r!==0?"none":e||t?"light":"orbit"}function yp(r,e,t){let[[n,s]]=e,i=s.x-r.get(n).x,a=s.y-r.get(n).y;if(Math.hypot(i,a)<Al)return null;let[o]=getComputedStyle(t).touchAction.split(" ");return gp[o]?.(i,a)?"scroll":"orbit"}function wp(r,e){let[[t,n],[s,i]]=e,a=r.get(t),o=r.get(s),l=$r(n,i),u={x:(n.x+i.x-a.x-o.x)/2,y:(n.y+i.y-a.y-o.y)/2},f=(g,_)=>({x:_.x-g.x,y:_.y-g.y}),p=Math.abs(Rl(f(a,o),f(n,i),{x:0,y:0}))*l/2,m=Math.max(Math.abs(l-$r(a,o))/2,Math.hypot(u.x,u.y));return Math.max(p,m)<Al?null:p>m?"twist":"pinch"}function bp(r,e,t,n){let s=-1/0,i=!1,a=!1,o=0;globalThis.addEventListener("wheel",l=>{i=l.timeStamp-s>dp||l.ctrlKey||l.metaKey,i&&(a=!1),s=l.timeStamp},{capture:!0,passive:!0,signal:n}),r.addEventListener("focus",()=>{s=-1/0}),r.addEventListener("wheel",l=>{if(i&&(a=t(l)),!a)return;l.preventDefault();let u=l.deltaMode===0?l.deltaY:l.deltaY*32;e.zoom(Math.exp(Math.min(300,Math.max(-300,u))*.0012),!0),clearTimeout(o),o=setTimeout(()=>e.settle(),200)},{passive:!1})}function xp(r,e){try{r.setPointerCapture(e)}catch{}}function Ap(r,e){if(r.ctrlKey||r.metaKey)return;let t=r.altKey||r.shiftKey?e.light:e.orbit,n={ArrowLeft:()=>t(-hn,0),ArrowRight:()=>t(hn,0),ArrowUp:()=>t(0,hn),ArrowDown:()=>t(0,-hn),"+":()=>e.zoom(1/1.1),"=":()=>e.zoom(1/1.1),"-":()=>e.zoom(1.1),a:()=>e.pan(-Gr,0),d:()=>e.pan(Gr,0),w:()=>e.pan(0,Gr),s:()=>e.pan(0,-Gr),"[":()=>e.light(-hn,0),"]":()=>e.light(hn,0),Home:()=>e.reset()},s=r.key.length===1?r.key.toLowerCase():r.key;Object.hasOwn(n,s)&&(r.preventDefault(),n[s]())}var{RNA_NONE:Tl,MAX_LAYERS:Sl,MAX_EXACT_INPUTS:kl,RNA_CHANNEL_GROUPS:Nl}=oe,pn=r=>Math.ceil(r/4);function jr(r,e,t,n=0){Ep(e);let{places:s,slots:i,queryGroups:a}=Rp(t,r.planes.channels,n),o=new Ii,l=Tl;e.int8&&(l=o.add(qr(e.gain,s,a)),o.add(qr(e.offset,s,a)));let u=e.layers.map((_,w)=>Il(o,_,w?null:s,w?0:a)),f=null;if(e.matrix){let _=e.matrix.length/e.outputs,w=new Float32Array(e.outputs);f=Il(o,{weight:e.matrix,bias:w,rows:_,columns:e.outputs,relu:!1},null,0)}let p=[...u,...f?[f]:[]],m=Math.max(...p.flatMap(({inputs:_,outputs:w})=>[_,w])),g=Sp(r,e,{queryGroups:a,gain:l,slots:i,layers:u,matrix:f});return{weights:o.all(),record:g,groups:Math.max(4,2**Math.ceil(Math.log2(m)))}}function Ep({layers:r,int8:e}){if(r.length>Sl)throw new $(`a decoder of ${r.length} layers; at most ${Sl}`);let t=e?Math.max(...r.map(({rows:n})=>n)):0;if(t>kl)throw new $(`an int8 layer of ${t} inputs; at most ${kl}`)}function Rp(r,e,t){let n=[],s=Ir.map(()=>Tl),i=0;for(let a of r){let o=Tr(a,e);s[Ir.indexOf(Ft(a))]=i;for(let l=0;l<o;l++)n.push(4*i+l);i+=pn(o)}for(let a=0;a<t;a++)n.push(4*i+a);return i+=pn(t),{places:n,slots:s,queryGroups:i}}var Ii=class{constructor(){this.list=[],this.length=0}add(e){let t=this.length;return this.list.push(e),this.length+=e.length/4,t}all(){let e=new Float32Array(4*this.length),t=0;for(let n of this.list)e.set(n,t),t+=n.length;return e}};function qr(r,e,t){let n=new Float32Array(4*t);return r.forEach((s,i)=>{n[e?e[i]:i]=s}),n}function Il(r,{weight:e,bias:t,rows:n,columns:s,step:i=0,scales:a,relu:o},l,u){let f=u||pn(n),p=pn(s),m=new Float32Array(16*f*p);for(let A=0;A<n;A++){let T=l?l[A]:A,F=T>>2;for(let G=0;G<s;G++)m[16*((G>>2)*f+F)+4*(T&3)+(G&3)]=e[A*s+G]}let g=r.add(m),_=r.add(qr(t,null,p)),w=a?r.add(qr(Float32Array.from(a,A=>A*i),null,p)):0;return{inputs:f,outputs:p,weights:g,bias:_,units:w,relu:Number(o),int8_step:i}}function Sp(r,e,{queryGroups:t,gain:n,slots:s,layers:i,matrix:a}){let{resolution:o,channels:l,precision:u,scales:f}=r.planes,{low:p,high:m,top:g,unit:_,factors:w=0,nearbyColumns:A=0,means:T=[]}=e,F=new Float32Array(12*Nl);for(let G=0;f&&G<3;G++)F.set(f.subarray(G*l,(G+1)*l),4*Nl*G);return pe("RnaPart",{low:r.bounds.min,high:r.bounds.max,resolution:o,channel_groups:pn(l),query_groups:t,layer_count:i.length,plane_precision:oe[`RNA_${u.toUpperCase()}`],gain:n,query_low:p,query_high:m,top:g,unit:_,matrix:a??{},scales:F,layers:i,slots:s,factors:w,nearby_columns:A,means:T})}function Ol({values:r,resolution:e,channels:t},n){let s=e*e,i=r.subarray(n*s*t,(n+1)*s*t),a=4*pn(t);if(a===t)return i;let o=new r.constructor(s*a);for(let l=0;l<s;l++)o.set(i.subarray(l*t,(l+1)*t),l*a);return o}var xt={surface:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","surface_blocks.wgsl","decoder.wgsl","surface.wgsl"],fiber:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","fiber_blocks.wgsl","decoder.wgsl","fiber.wgsl"],evaluate:["row_records.wgsl","arguments.wgsl","evaluate.wgsl"],"render/step":["render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl","render/sampler.wgsl"],"render/scene":["render/step","geometry_records.wgsl","geometry.wgsl","segment.wgsl","normal_maps.wgsl","visibility.wgsl","render/surfaces.wgsl","images.wgsl","render/textures.wgsl","render/transmittance.wgsl","render/base_color.wgsl","render/bumps.wgsl","render/vertex.wgsl"],"render/lit":["render/directions.wgsl","render/lights.wgsl","render/environment.wgsl","render/triangle_lights.wgsl"],"render/traced":["triangle.wgsl","bvh.wgsl","render/light_shapes.wgsl","render/passing.wgsl","render/tracing.wgsl"],rays:["render/scene","triangle.wgsl","bvh.wgsl","render/passing.wgsl","render/tracing.wgsl","render/solid_glass.wgsl"],hit:["rays"],light:["rays","render/lit","render/light_shapes.wgsl","render/ggx.wgsl","render/lobes.wgsl","render/surface_lobes.wgsl"],nearby:["render/scene","render/directions.wgsl","triangle.wgsl","bvh.wgsl","render/passing.wgsl","render/nearby_light.wgsl"],columns:["geometry_records.wgsl","queue"],queue:["row_records.wgsl","render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl"]},At={"arguments.wgsl":`// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
// by their bits, since WGSL may assume that there is no NaN, and may take subnormal numbers for 0.

const RNA_EXPONENT: u32 = 0x7f800000u;

fn rna_is_finite(bits: vec4<u32>) -> bool {
    return all((bits & vec4<u32>(RNA_EXPONENT)) != vec4<u32>(RNA_EXPONENT));
}

// A component, divided by 2^(largest - 127); of a subnormal largest 0, by 2^-149.
fn rna_scaled(bits: u32, largest: u32) -> f32 {
    let exponent = (bits & RNA_EXPONENT) >> 23u;
    let mantissa = f32(bits & 0x7fffffu);
    var size = 0.0;
    if largest == 0u {
        size = mantissa;
    } else if exponent != 0u {
        let down = largest - exponent;
        if down < 64u {
            size = bitcast<f32>(((127u - down) << 23u) | (bits & 0x7fffffu));
        }
    } else if largest < 64u {
        size = mantissa * bitcast<f32>((105u - largest) << 23u);
    }
    return select(size, -size, (bits >> 31u) == 1u);
}

// The unit vector along one of any length; 0 of length 0.
fn rna_unit(bits: vec3<u32>) -> vec3f {
    let exponents = (bits & vec3<u32>(RNA_EXPONENT)) >> vec3<u32>(23u);
    let largest = max(exponents.x, max(exponents.y, exponents.z));
    var v: vec3f;
    for (var k = 0u; k < 3u; k++) {
        v[k] = rna_scaled(bits[k], largest);
    }
    let square = dot(v, v);
    if square == 0.0 {
        return vec3f(0.0);
    }
    return v / sqrt(square);
}
`,"blocks.wgsl":`// Where input blocks are written: spec/RNA.md, 6.3 Input blocks. Each block starts at a group of 4
// columns of its own; the packer has spread the rows of the first matrix likewise.

// First group of an input block, RNA_NONE where the decoder does not have it.
fn rna_slot(block: u32) -> u32 {
    return rna_part.slots[block / 4u][block % 4u];
}

fn rna_put(slot: u32, values: vec4f) {
    if slot != RNA_NONE {
        rna_values[slot] = values;
    }
}

// The largest absolute component.
fn rna_largest(v: vec3f) -> f32 {
    return max(max(abs(v.x), abs(v.y)), abs(v.z));
}

// Writes \`features\`; returns the first three. p: of rna_relative.
fn rna_put_features(p: vec3f) -> vec3f {
    let texels = rna_texels(p);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    let groups = select(rna_part.channel_groups, 1u, slot == RNA_NONE);
    var first = vec4f(0.0);
    for (var group = 0u; group < groups; group++) {
        let features = rna_features(texels, group);
        first = select(first, features, group == 0u);
        rna_put(select(slot + group, RNA_NONE, slot == RNA_NONE), features);
    }
    return first.xyz;
}
`,"bvh.wgsl":`// Closest and any hits: a tree over instances, and one in each body's object space. Loops take
// their lengths from the data. Of every hit of a triangle they call
//     fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool
// which opaque.wgsl answers, or a host that knows what lets light through; found: (t, b1, b2).

// Nodes to come back to: of the tree over instances, then of a body's. Private, since a function's own
// array would be set to 0 at every call.
var<private> rna_stack: array<u32, 2u * RNA_STACK>;

fn rna_inverse(d: vec3f) -> vec3f {
    let tiny = select(vec3f(1e-20), vec3f(-1e-20), d < vec3f(0.0));
    return vec3f(1.0) / select(d, tiny, abs(d) < vec3f(1e-20));
}

// Where the ray enters a node's box; RNA_FAR where it does not.
fn rna_enter_node(node: u32, origin: vec3f, inverse: vec3f, near: f32, far: f32) -> f32 {
    let a = (rna_nodes[node].low - origin) * inverse;
    let b = (rna_nodes[node].high - origin) * inverse;
    let lower = min(a, b);
    let upper = max(a, b);
    let enter = max(max(lower.x, lower.y), max(lower.z, near));
    let leave = min(min(upper.x, upper.y), min(upper.z, far));
    return select(RNA_FAR, enter, enter <= leave * 1.0000005);
}

// The next node down, nearer child first; RNA_NOTHING where none is hit.
fn rna_descend(
    node: u32, ray: RnaRay, inverse: vec3f, far: f32, top: ptr<function, u32>,
) -> u32 {
    let left = node + 1u;
    let right = rna_nodes[node].child;
    let to_left = rna_enter_node(left, ray.origin, inverse, ray.near, far);
    let to_right = rna_enter_node(right, ray.origin, inverse, ray.near, far);
    if to_left >= RNA_FAR && to_right >= RNA_FAR {
        return RNA_NOTHING;
    }
    if to_left >= RNA_FAR {
        return right;
    }
    if to_right >= RNA_FAR {
        return left;
    }
    let left_first = to_left <= to_right;
    rna_stack[*top] = select(left, right, left_first);
    *top += 1u;
    return select(right, left, left_first);
}

// Tests a primitive; whether it is hit nearer than \`hit\`, which is then set to it.
fn rna_meet(primitive: u32, ray: RnaRay, start_strand: u32, hit: ptr<function, RnaHit>) -> bool {
    let record = rna_primitives[primitive];
    let line = RnaRay(ray.origin, ray.near, ray.direction, (*hit).t);
    if !rna_is_segment(record) {
        let crossing = rna_meet_triangle(
            line, rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
        );
        if crossing.x >= RNA_FAR || !rna_stops(primitive, ray, crossing, (*hit).instance) {
            return false;
        }
        *hit = RnaHit(crossing.x, (*hit).instance, primitive, crossing.y, crossing.z, vec3f(0.0));
        return true;
    }
    if rna_strand(record) == start_strand {
        return false;
    }
    let entry = rna_meet_segment(line, record);
    if entry.t >= RNA_FAR {
        return false;
    }
    *hit = RnaHit(entry.t, (*hit).instance, primitive, entry.u, 0.0, entry.normal);
    return true;
}

// The closest hit of a body below \`root\`, ray in its object space, nearer than \`hit\`; with \`any\`
// the first that is found.
fn rna_trace_body(
    root: u32, ray: RnaRay, start_strand: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    var top = RNA_STACK;
    var node = root;
    var is_hit = false;
    let inverse = rna_inverse(ray.direction);
    while node != RNA_NOTHING {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, (*hit).t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count && !(any && is_hit); k++) {
            is_hit = rna_meet(first + k, ray, start_strand, hit) || is_hit;
        }
        if next == RNA_NOTHING && top > RNA_STACK {
            top -= 1u;
            next = rna_stack[top];
        }
        node = select(next, RNA_NOTHING, any && is_hit);
    }
    return is_hit;
}

// Tests an instance, world ray; \`ignored\` is passed through, and so is what \`rays\` has no bit of.
fn rna_trace_instance(
    instance: u32, ray: RnaRay, ignored: u32, rays: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    if instance == ignored || (rna_instances[instance].rays & rays) == 0u {
        return false;
    }
    let scale = rna_instances[instance].scale;
    let local = rna_to_object(ray, instance);
    var nearest = *hit;
    nearest.instance = instance;
    nearest.t = min((*hit).t / scale, RNA_FAR);
    if !rna_trace_body(rna_instances[instance].root, local, RNA_NOTHING, any, &nearest) {
        return false;
    }
    nearest.t *= scale;
    *hit = nearest;
    return true;
}

// The closest hit in the world, or with \`any\` some hit.
fn rna_trace(ray: RnaRay, ignored: u32, rays: u32, any: bool) -> RnaHit {
    var hit = rna_miss(ray.far);
    var top = 0u;
    var node = 0u;
    var is_hit = false;
    let inverse = rna_inverse(ray.direction);
    while node != RNA_NOTHING {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, hit.t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count && !(any && is_hit); k++) {
            is_hit = rna_trace_instance(first + k, ray, ignored, rays, any, &hit) || is_hit;
        }
        if next == RNA_NOTHING && top > 0u {
            top -= 1u;
            next = rna_stack[top];
        }
        node = select(next, RNA_NOTHING, any && is_hit);
    }
    return hit;
}
`,"decoder.wgsl":`// The decoder: spec/RNA.md, 6.4 Decoder profile. All loops take their lengths from RnaPart: shaders
// that are unrolled take minutes to compile. Drivers inline each call: one call, in a loop, compiles
// sooner than two.

const RNA_LARGEST: f32 = 3.4028234e38;

struct RnaTransport {
    visible: vec3f, // of a decoder of one colour: that one, as what is emitted
    shadowed: vec3f,
}

// Clip, and gain and offset of an int8 decoder.
fn rna_prepare_queries() {
    for (var k = 0u; k < rna_part.query_groups; k++) {
        var x = clamp(rna_values[k], vec4f(rna_part.query_low), vec4f(rna_part.query_high));
        if rna_part.gain != RNA_NONE {
            x = x * rna_weight(rna_part.gain + k)
                + rna_weight(rna_part.gain + rna_part.query_groups + k);
        }
        rna_values[k] = x;
    }
}

// QuantizeLinear: whole numbers from 0 to 255, halves to even.
fn rna_quantize(layer: RnaLayer, source: u32) {
    for (var k = 0u; k < layer.inputs; k++) {
        let x = rna_values[source + k] / layer.int8_step;
        rna_values[source + k] = clamp(round(x), vec4f(0.0), vec4f(255.0));
    }
}

// What a group of columns adds to the sums of an output group, with its block at \`at\`.
fn rna_block(x: vec4f, at: u32) -> vec4f {
    return x.x * rna_weight(at) + x.y * rna_weight(at + 1u)
        + x.z * rna_weight(at + 2u) + x.w * rna_weight(at + 3u);
}

fn rna_finish(layer: RnaLayer, o: u32, sums: vec4f, place: u32) {
    var y = sums + rna_weight(layer.bias + o);
    if layer.int8_step != 0.0 {
        y *= rna_weight(layer.units + o);
    }
    if layer.relu == 1u {
        y = max(y, vec4f(0.0));
    }
    rna_values[place + o] = y;
}

// Four output groups at a time: a value is read once for 16 sums. Sums of int8 layers are whole
// and below 2^24: exact.
fn rna_run_layer(layer: RnaLayer, source: u32, place: u32) {
    if layer.int8_step != 0.0 {
        rna_quantize(layer, source);
    }
    let stride = 4u * layer.inputs;
    for (var o = 0u; o < layer.outputs; o += 4u) {
        var a = vec4f(0.0);
        var b = vec4f(0.0);
        var c = vec4f(0.0);
        var d = vec4f(0.0);
        var at = layer.weights + o * stride;
        for (var k = 0u; k < layer.inputs; k++) {
            let x = rna_values[source + k];
            a += rna_block(x, at);
            b += rna_block(x, at + stride);
            c += rna_block(x, at + 2u * stride);
            d += rna_block(x, at + 3u * stride);
            at += 4u;
        }
        var sums = array<vec4f, 4>(a, b, c, d); // some of groups that the layer does not have
        for (var k = 0u; k < min(4u, layer.outputs - o); k++) {
            rna_finish(layer, o + k, sums[k], place);
        }
    }
}

// What the last layer gives, clipped, as radiance.
fn rna_expand(source: u32) {
    let last = rna_part.layers[rna_part.layer_count - 1u].outputs;
    for (var k = 0u; k < last; k++) {
        let x = clamp(rna_values[source + k], vec4f(0.0), vec4f(rna_part.top));
        rna_values[source + k] = (exp(x) - 1.0) * rna_part.unit;
    }
}

// The place of the results in rna_values, from the queries there.
fn rna_run_decoder() -> u32 {
    rna_prepare_queries();
    var source = 0u;
    for (var k = 0u; k <= rna_part.layer_count; k++) {
        var layer = rna_part.matrix;
        if k < rna_part.layer_count {
            layer = rna_part.layers[k];
        } else {
            rna_expand(source);
        }
        if layer.inputs == 0u {
            break; // there is no matrix
        }
        rna_run_layer(layer, source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    return source;
}

// Three columns of the results at \`place\`, from column k on.
fn rna_columns(place: u32, k: u32) -> vec3f {
    let x = rna_values[place + k / 4u][k % 4u];
    let y = rna_values[place + (k + 1u) / 4u][(k + 1u) % 4u];
    let z = rna_values[place + (k + 2u) / 4u][(k + 2u) % 4u];
    return vec3f(x, y, z);
}

// A result, from its terms, of which the second is multiplied by the base colour; each is that of the first set of columns,
// plus those of the others times nearby light: spec/RNA.md, 7.3.
fn rna_colour(place: u32, result: u32, base_color: vec3f, nearby: vec4f) -> vec3f {
    let shares = vec4f(1.0, select(rna_part.means[result].xyz, max(nearby.xyz, vec3f(0.0)), nearby.w != 0.0));
    let terms = select(1u, 2u, rna_part.factors != 0u);
    let sets = select(1u, 4u, rna_part.nearby_columns != 0u);
    var colour = vec3f(0.0);
    for (var term = 0u; term < terms; term++) {
        let first = 3u * result + term * rna_part.factors;
        var sum = vec3f(0.0);
        for (var k = 0u; k < sets; k++) {
            sum += shares[k] * rna_columns(place, first + k * rna_part.nearby_columns);
        }
        colour += select(vec3f(1.0), base_color, term == 1u) * sum;
    }
    return clamp(colour, vec3f(0.0), vec3f(RNA_LARGEST));
}

// The colours for the queries in rna_values.
fn rna_decode(base_color: vec3f, nearby: vec4f) -> RnaTransport {
    let place = rna_run_decoder();
    var colours: array<vec3f, 2>;
    for (var k = 0u; k < 2u; k++) {
        colours[k] = rna_colour(place, k, base_color, nearby);
    }
    return RnaTransport(colours[0], colours[1]);
}
`,"environment_lobes.wgsl":`// Lobes of the transport for light from whole environments: spec/RNA.md, 12, RNA_environment. Whoever composes the files
// declares RNA_LOBES, RNA_IS_FIBER (1 or 0) and RNA_VISIBILITY_GROUPS: 4, or 0 of parts without harmonics.

const RNA_AXIS_SHIFT: f32 = 8.0;
const RNA_LEAST_KAPPA: f32 = 0.01;
const RNA_WIDE: f32 = 2.0; // kappa of a lobe that the decoder leaves as it is, of the first half
const RNA_SHARP: f32 = 10.0; // and of the rest

struct RnaLobe {
    amplitude: vec3f,
    kappa: f32,
    axis: vec3f, // its length is kappa, but for those below RNA_LEAST_KAPPA
}

// Runs the decoder. m: the mirror direction. visibility: harmonics of the asset's own, coefficients. The result is where
// rna_lobe finds its values.
fn rna_run_lobes(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, m: vec3f, visibility: array<vec4f, 4>,
) -> u32 {
    rna_put_queries(x, axis, h, wo, m, axis); // the half vector of surfaces is n
    let first = rna_part.query_groups - RNA_VISIBILITY_GROUPS;
    for (var k = 0u; k < RNA_VISIBILITY_GROUPS; k++) {
        rna_values[first + k] = visibility[k];
    }
    return rna_run_decoder();
}

fn rna_three(place: u32, k: u32) -> vec3f {
    return max(rna_columns(place, k), vec3f(0.0));
}

// Lobe j. free: the asset's own visibility along m.
fn rna_lobe(place: u32, j: u32, axis: vec3f, wo: vec3f, m: vec3f, free: f32) -> RnaLobe {
    var base = RNA_SHARP * m;
    if j < RNA_LOBES / 2u {
        base = RNA_WIDE * select(axis, -wo, RNA_IS_FIBER == 1u);
    }
    let a = rna_three(place, 9u * j + 6u) - RNA_AXIS_SHIFT + base;
    let amplitude = mix(rna_three(place, 9u * j + 3u), rna_three(place, 9u * j), clamp(free, 0.0, 1.0));
    return RnaLobe(amplitude, max(length(a), RNA_LEAST_KAPPA), a);
}
`,"evaluate.wgsl":`// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read_write> rna_results: array<vec4f>;
@group(1) @binding(2) var<storage, read> rna_row_count: array<u32>; // [0]

// Whoever composes the files declares RNA_COLOURS, those that the decoder gives; RNA_STRIDE, those of a row of the
// results; and RNA_FIRST, the place in the row where the decoder's begin.
fn rna_write(row: u32, result: RnaTransport) {
    rna_results[RNA_STRIDE * row + RNA_FIRST] = vec4f(result.visible, 0.0);
    if RNA_COLOURS == 2u {
        rna_results[RNA_STRIDE * row + 1u] = vec4f(result.shadowed, 0.0);
    }
}

@compute @workgroup_size(64)
fn rna_evaluate(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= rna_row_count[0] {
        return;
    }
    let at = rna_rows[row];
    let finite = rna_is_finite(vec4<u32>(at.position, at.h)) && rna_is_finite(vec4<u32>(at.axis, 0u))
        && rna_is_finite(vec4<u32>(at.wo, 0u)) && rna_is_finite(vec4<u32>(at.wi, 0u));
    let base_color = vec3<u32>(at.red, at.green, at.blue);
    let known = (rna_part.factors == 0u || rna_is_finite(vec4<u32>(base_color, 0u)))
        && (rna_part.nearby_columns == 0u || at.has_nearby == 0u || rna_is_finite(vec4<u32>(at.nearby, 0u)));
    let a = rna_unit(at.axis);
    let o = rna_unit(at.wo);
    let i = rna_unit(at.wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && known && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        let nearby = vec4f(bitcast<vec3f>(at.nearby), f32(at.has_nearby));
        let color = bitcast<vec3f>(base_color);
        result = rna_query(bitcast<vec3f>(at.position), a, bitcast<f32>(at.h), o, i, color, nearby);
    }
    rna_write(row, result);
}
`,"fiber.wgsl":`// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi. nearby: as of a surface.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f, nearby: vec4f) -> RnaTransport {
    rna_put_queries(x, t, h, wo, wi, wi);
    return rna_decode(vec3f(1.0), nearby);
}

// The last argument is the half vector of surfaces.
fn rna_put_queries(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f, m: vec3f) {
    let p = rna_relative(x);
    rna_put_features(p);
    rna_fiber_blocks(p, t, clamp(h, -1.0, 1.0), wo, wi);
}

fn rna_query(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f, base_color: vec3f, nearby: vec4f,
) -> RnaTransport {
    return rna_fiber(x, axis, h, wo, wi, nearby);
}
`,"fiber_blocks.wgsl":`// Input blocks of a fiber, but \`features\`. Generated by \`python -m rna_sdk.package.write_blocks\`; do not edit. Formulas: RNA.md, 6.3.

fn rna_fiber_blocks(p: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    if rna_slot(RNA_BLOCK_POSITION) != RNA_NONE {
        rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    }
    rna_put(rna_slot(RNA_BLOCK_TANGENT), vec4f(t, 0.0));
    rna_put(rna_slot(RNA_BLOCK_H), vec4f(h, 0.0, 0.0, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    if rna_slot(RNA_BLOCK_FIBER_ANGLES) != RNA_NONE || rna_slot(RNA_BLOCK_FIBER_LOBES) != RNA_NONE {
        let s_o = dot(t, wo);
        let o = cross(t, wo);
        let i = cross(t, wi);
        let o_i = cross(o, i);
        let c_o = length(o);
        let d = c_o * length(i);
        let along = d < 1e-06;
        let cos_phi = select(clamp(dot(o, i) / max(d, 1e-06), -1.0, 1.0), 1.0, along);
        let sin_phi = select(clamp(dot(t, o_i) / max(d, 1e-06), -1.0, 1.0), 0.0, along);
        if rna_slot(RNA_BLOCK_FIBER_ANGLES) != RNA_NONE {
            let s_i = dot(t, wi);
            let cone = s_i + s_o;
            rna_put(rna_slot(RNA_BLOCK_FIBER_ANGLES), vec4f(s_i, s_o, cone, log2(cone * cone + 0.001) / 6.0));
            rna_put(rna_slot(RNA_BLOCK_FIBER_ANGLES) + 1u, vec4f(cos_phi, sin_phi, 0.0, 0.0));
        }
        if rna_slot(RNA_BLOCK_FIBER_LOBES) != RNA_NONE {
            let sin_t = h * c_o / sqrt(1.55 * 1.55 - s_o * s_o);
            let segment_cos = 2.0 * sin_t * sin_t - 1.0;
            let segment_sin = 2.0 * sin_t * sqrt((1.0 - sin_t) * (1.0 + sin_t));
            let r_cos = 1.0 - 2.0 * h * h;
            let r_sin = 2.0 * h * sqrt((1.0 - h) * (1.0 + h));
            let tt_cos = r_cos * segment_cos - r_sin * segment_sin;
            let tt_sin = r_cos * segment_sin + r_sin * segment_cos;
            let trt_cos = tt_cos * segment_cos - tt_sin * segment_sin;
            let trt_sin = tt_cos * segment_sin + tt_sin * segment_cos;
            rna_put(rna_slot(RNA_BLOCK_FIBER_LOBES), vec4f(cos_phi * r_cos + sin_phi * r_sin, cos_phi * tt_cos + sin_phi * tt_sin, cos_phi * trt_cos + sin_phi * trt_sin, 0.0));
        }
    }
}
`,"geometry.wgsl":`// Geometry and rays: spec/RNA.md, 4 Geometry. Trees, triangles and segments of all bodies lie in
// three buffers; instances place the bodies in the world. \`geometry.py\` fills them.

// The tree over instances comes first.
@group(2) @binding(0) var<storage, read> rna_nodes: array<RnaNode>;

@group(2) @binding(1) var<storage, read> rna_primitives: array<RnaPrimitive>;

// Position and, of curves, radius; the fourth number of a mesh's points is the host's.
@group(2) @binding(2) var<storage, read> rna_points: array<vec4f>;

@group(2) @binding(3) var<storage, read> rna_instances: array<RnaInstance>;

const RNA_FAR: f32 = 1e30;
const RNA_STACK: u32 = 48u;

struct RnaRay {
    origin: vec3f,
    near: f32,
    direction: vec3f, // unit
    far: f32,
}

struct RnaHit {
    t: f32,
    instance: u32, // RNA_NOTHING for a miss
    primitive: u32,
    b1: f32, // barycentric coordinates of a triangle's second and third corner; of a segment u of RnaEntry, 0
    b2: f32,
    normal: vec3f, // outward, of a segment
}

fn rna_miss(far: f32) -> RnaHit {
    return RnaHit(far, RNA_NOTHING, 0u, 0.0, 0.0, vec3f(0.0));
}

fn rna_is_segment(primitive: RnaPrimitive) -> bool {
    return (primitive.tag & RNA_IS_SEGMENT) != 0u;
}

fn rna_surface(primitive: RnaPrimitive) -> u32 {
    return primitive.tag >> RNA_SURFACE_SHIFT;
}

// Of a segment.
fn rna_strand(primitive: RnaPrimitive) -> u32 {
    return primitive.c;
}

// The size of a triangle's box, from its edges from the first corner.
fn rna_box_size(e1: vec3f, e2: vec3f) -> vec3f {
    let zero = vec3f(0.0);
    return max(max(e1, e2), zero) - min(min(e1, e2), zero);
}

// The ray in an instance's object space, where its direction is unit as well.
fn rna_to_object(ray: RnaRay, instance: u32) -> RnaRay {
    let scale = rna_instances[instance].scale;
    return RnaRay(
        rna_object_point(ray.origin, instance),
        ray.near / scale,
        rna_object_direction(ray.direction, instance),
        min(ray.far / scale, RNA_FAR),
    );
}

fn rna_object_point(x: vec3f, instance: u32) -> vec3f {
    let p = vec4f(x, 1.0);
    return vec3f(
        dot(rna_instances[instance].to_object[0], p),
        dot(rna_instances[instance].to_object[1], p),
        dot(rna_instances[instance].to_object[2], p),
    );
}

fn rna_object_direction(d: vec3f, instance: u32) -> vec3f {
    return d.x * rna_instances[instance].rotation[0].xyz
        + d.y * rna_instances[instance].rotation[1].xyz
        + d.z * rna_instances[instance].rotation[2].xyz;
}

fn rna_world_direction(d: vec3f, instance: u32) -> vec3f {
    return vec3f(
        dot(rna_instances[instance].rotation[0].xyz, d),
        dot(rna_instances[instance].rotation[1].xyz, d),
        dot(rna_instances[instance].rotation[2].xyz, d),
    );
}

fn rna_world_point(x: vec3f, instance: u32) -> vec3f {
    return rna_instances[instance].scale * rna_world_direction(x, instance)
        + rna_instances[instance].place;
}
`,"geometry_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NOTHING: u32 = 0xffffffffu;
const RNA_IS_SEGMENT: u32 = 1u;
const RNA_SURFACE_SHIFT: u32 = 1u;
const RNA_HAS_BEFORE: u32 = 1u;
const RNA_HAS_AFTER: u32 = 2u;

struct RnaNode { // 32 bytes
    low: vec3f, // 0
    child: u32, // 12; the right one, the left one is the next node; a leaf's first primitive
    high: vec3f, // 16
    count: u32, // 28; a leaf's primitives; 0 of inner nodes
}

struct RnaPrimitive { // 16 bytes
    a: u32, // 0; point: a triangle's first corner, a segment's start
    b: u32, // 4; second corner; of a segment RNA_HAS_BEFORE and RNA_HAS_AFTER
    c: u32, // 8; third corner; of a segment its strand
    tag: u32, // 12; surface << RNA_SURFACE_SHIFT, and RNA_IS_SEGMENT
}

struct RnaInstance { // 128 bytes
    to_object: array<vec4f, 3>, // 0; rows of the matrix
    rotation: array<vec4f, 3>, // 48; to the world: rows, the fourth column free
    place: vec3f, // 96; in the world
    scale: f32, // 108; to the world
    root: u32, // 112; node
    rays: u32, // 116; bits of those that can hit it
    extent: f32, // 120; largest coordinate of its body
    host_data: u32, // 124; a number of the host's
}
`,"images.wgsl":`// Images on triangles: spec/RNA.md, 4.6 Base colour; textures of materials are looked up likewise. A texel is a
// u32 of three bytes; levels lie one behind the other. The host declares
//     fn rna_image_word(at: u32) -> u32

const RNA_REPEAT: u32 = 0u;
const RNA_MIRROR: u32 = 2u;
const RNA_IS_SRGB: u32 = 16u;
const RNA_MIXES_SRGB: u32 = 256u; // of base colours: encoded values are mixed

struct RnaImage {
    place: u32,
    size: vec2<u32>, // columns, rows
    form: u32, // wrap in u and in v, 2 bits each; RNA_IS_SRGB or RNA_MIXES_SRGB
}

fn rna_texel_of(at: RnaImage, column: u32, row: u32) -> vec3f {
    let word = rna_image_word(at.place + row * at.size.x + column);
    let c = vec3f((vec3<u32>(word) >> vec3<u32>(0u, 8u, 16u)) & vec3<u32>(255u)) / 255.0;
    if (at.form & RNA_IS_SRGB) == 0u {
        return c;
    }
    return rna_linear(c);
}

fn rna_linear(c: vec3f) -> vec3f {
    return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

struct RnaAround {
    first: u32,
    second: u32,
    part: f32,
}

// The two texels whose centres x is between.
fn rna_texels_around(x: f32, size: u32, wrap: u32) -> RnaAround {
    var inside = clamp(x, 0.0, 1.0);
    if wrap == RNA_REPEAT {
        inside = x - floor(x);
    } else if wrap == RNA_MIRROR {
        let twice = x - 2.0 * floor(0.5 * x);
        inside = select(twice, 2.0 - twice, twice > 1.0);
    }
    let place = inside * f32(size) - 0.5;
    let low = floor(place);
    let first = i32(low);
    let last = i32(size) - 1;
    if wrap == RNA_REPEAT {
        let wrapped = select(first, last, first < 0);
        return RnaAround(u32(wrapped), u32(select(first + 1, 0, first + 1 > last)), place - low);
    }
    return RnaAround(u32(max(first, 0)), u32(min(first + 1, last)), place - low);
}

// Bilinear, at coordinates of the image.
fn rna_image_color(at: RnaImage, place: vec2f) -> vec3f {
    let x = rna_texels_around(place.x, at.size.x, at.form & 3u);
    let y = rna_texels_around(place.y, at.size.y, (at.form >> 2u) & 3u);
    var color = vec3f(0.0);
    for (var k = 0u; k < 4u; k++) {
        let right = (k & 1u) == 1u;
        let below = k > 1u;
        let weight = select(1.0 - x.part, x.part, right) * select(1.0 - y.part, y.part, below);
        color += weight * rna_texel_of(at, select(x.first, x.second, right), select(y.first, y.second, below));
    }
    if (at.form & RNA_MIXES_SRGB) == 0u {
        return color;
    }
    return rna_linear(color);
}

// The next level, of half the size.
fn rna_next_level(at: RnaImage) -> RnaImage {
    return RnaImage(at.place + at.size.x * at.size.y, max(at.size / 2u, vec2<u32>(1u)), at.form);
}

// At a level that need not be whole; \`at\` is level 0, the last level has one texel.
fn rna_image_color_at(at: RnaImage, place: vec2f, level: f32) -> vec3f {
    var finer = at;
    let whole = u32(level);
    for (var k = 0u; k < whole && any(finer.size > vec2<u32>(1u)); k++) {
        finer = rna_next_level(finer);
    }
    let rest = select(level - f32(whole), 0.0, all(finer.size == vec2<u32>(1u)));
    var color = vec3f(0.0);
    for (var k = 0u; k < select(2u, 1u, rest == 0.0); k++) {
        color += select(1.0 - rest, rest, k == 1u) * rna_image_color(finer, place);
        finer = rna_next_level(finer);
    }
    return color;
}

// The level whose texels are as wide as \`width\` on a triangle of the corners p. uv: of the corners in the image.
fn rna_level_for(at: RnaImage, p: mat3x3f, uv: mat3x2f, width: f32) -> f32 {
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let texels = abs(d1.x * d2.y - d2.x * d1.y) * f32(at.size.x) * f32(at.size.y);
    let area = length(cross(p[1] - p[0], p[2] - p[0]));
    let wide = width * sqrt(select(0.0, texels / area, area > 0.0));
    return log2(max(wide, 1.0));
}
`,"normal_maps.wgsl":`// The mapped normal of a hit: spec/RNA.md, 4.5 Normal maps. The host declares
//     fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f
// which gives the two numbers from 0 to 255 of a texel.

// at modulo sides. Vulkan leaves \`%\` of a negative number undefined, and drivers differ.
fn rna_repeated(at: vec2<i32>, sides: vec2<i32>) -> vec2<i32> {
    let left = at - at / sides * sides;
    return select(left, left + sides, left < vec2<i32>(0));
}

// x and y of a map of \`size\` (columns, rows) at uv; it repeats.
fn rna_map_value(map: u32, size: vec2<u32>, uv: vec2f) -> vec2f {
    let at = uv * vec2f(size) - 0.5;
    let low = floor(at);
    let part = at - low;
    let sides = vec2<i32>(size);
    let i = vec2<u32>(rna_repeated(vec2<i32>(low), sides));
    let j = vec2<u32>(rna_repeated(vec2<i32>(low) + 1, sides));
    let upper = mix(rna_map_texel(map, i.y, i.x), rna_map_texel(map, i.y, j.x), part.x);
    let lower = mix(rna_map_texel(map, j.y, i.x), rna_map_texel(map, j.y, j.x), part.x);
    return (mix(upper, lower, part.y) - 127.0) / 127.0;
}

// n: interpolated normal; p: corners; uv: their texture coordinates; b: barycentric coordinates.
fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    let e1 = p[1] - p[0];
    let e2 = p[2] - p[0];
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = sign(area);
    let along_u = (d2.y * e1 - d1.y * e2) * side;
    let along_v = (d1.x * e2 - d2.x * e1) * side;
    let t = along_u - dot(along_u, n) * n;
    if area == 0.0 || length(t) <= 1e-6 * length(along_u) {
        return n;
    }
    let tangent = normalize(t);
    var bitangent = cross(n, tangent);
    if dot(bitangent, along_v) > 0.0 {
        bitangent = -bitangent;
    }
    let xy = rna_map_value(map, size, uv * b);
    let z = sqrt(max(0.0, 1.0 - dot(xy, xy)));
    let m = xy.x * tangent + xy.y * bitangent + z * n;
    if length(m) <= 1e-6 {
        return n;
    }
    return normalize(m);
}
`,"part.wgsl":`// The bindings of one part of a tier: spec/RNA.md, 3 Manifest and 6.4 Decoder profile.

@group(0) @binding(0) var<uniform> rna_part: RnaPart;
@group(0) @binding(2) var<storage, read> rna_plane_xy: array<u32>;
@group(0) @binding(3) var<storage, read> rna_plane_yz: array<u32>;
@group(0) @binding(4) var<storage, read> rna_plane_zx: array<u32>;

// The queries' columns, and the values between layers: two halves of RNA_GROUPS groups, read and
// written by turns. RNA_GROUPS is declared by whoever composes the files.
var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;

fn rna_plane_word(plane: u32, at: u32) -> u32 {
    switch plane {
        case 0u: { return rna_plane_xy[at]; }
        case 1u: { return rna_plane_yz[at]; }
        default: { return rna_plane_zx[at]; }
    }
}
`,"part_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NONE: u32 = 0xffffffffu;
const RNA_FLOAT32: u32 = 0u;
const RNA_FLOAT16: u32 = 1u;
const RNA_INT8: u32 = 2u;
const RNA_BLOCK_FEATURES: u32 = 0u;
const RNA_BLOCK_POSITION: u32 = 1u;
const RNA_BLOCK_NORMAL: u32 = 2u;
const RNA_BLOCK_TANGENT: u32 = 3u;
const RNA_BLOCK_H: u32 = 4u;
const RNA_BLOCK_WO: u32 = 5u;
const RNA_BLOCK_WI: u32 = 6u;
const RNA_BLOCK_HALF_VECTOR: u32 = 7u;
const RNA_BLOCK_HIGHLIGHT: u32 = 8u;
const RNA_BLOCK_LEARNED_NORMAL: u32 = 9u;
const RNA_BLOCK_FIBER_ANGLES: u32 = 10u;
const RNA_BLOCK_FIBER_LOBES: u32 = 11u;
const RNA_CHANNEL_GROUPS: u32 = 16u;

struct RnaLayer { // 32 bytes
    inputs: u32, // 0; groups of 4 columns
    outputs: u32, // 4
    weights: u32, // 8; place of [outputs][inputs][4] vec4f
    bias: u32, // 12; place of [outputs] vec4f
    units: u32, // 16; place of [outputs] vec4f of an int8 layer: what a sum of 1 means
    relu: u32, // 20; 1: negative results are 0
    int8_step: f32, // 24; of an int8 layer: what 1 means in its inputs; else 0
    reserved: u32, // 28
}

struct RnaPart { // 1984 bytes
    low: vec3f, // 0; smallest corner of the bounds
    resolution: u32, // 12
    high: vec3f, // 16
    channel_groups: u32, // 28; channels / 4, rounded up
    query_groups: u32, // 32; of the decoder's input
    layer_count: u32, // 36
    plane_precision: u32, // 40; RNA_FLOAT32, RNA_FLOAT16 or RNA_INT8
    gain: u32, // 44; place of [query_groups] gains, then the offsets; RNA_NONE without
    query_low: f32, // 48; the decoder's first Clip
    query_high: f32, // 52
    top: f32, // 56; of the Clip before Exp
    unit: f32, // 60; result = (exp(x) - 1) unit, or times the matrix; then 1
    matrix: RnaLayer, // 64; [n, columns of the results], with a bias of 0; all 0 without
    scales: array<vec4f, 48>, // 96; of int8 planes, [plane][group]
    layers: array<RnaLayer, 32>, // 864
    slots: array<vec4<u32>, 3>, // 1888; first group of each block, RNA_NONE for none: see rna_slot
    factors: u32, // 1936; column of the results where those of base colour begin; 0 without
    nearby_columns: u32, // 1940; of each of the four sets with nearby light; 0 without
    means: array<vec4f, 2>, // 1952; of nearby light, for the results of rows without it
}
`,"planes.wgsl":`// Features of a position: spec/RNA.md, 5 Planes.

// Values of float16; drivers may take subnormal ones for 0, the format does not.
fn rna_from_float16(bits: vec4<u32>) -> vec4f {
    let exponent = (bits >> vec4<u32>(10u)) & vec4<u32>(31u);
    let mantissa = bits & vec4<u32>(1023u);
    let size = select(
        bitcast<vec4f>(((exponent + 112u) << vec4<u32>(23u)) | (mantissa << vec4<u32>(13u))),
        vec4f(mantissa) * 0x1p-24f,
        exponent == vec4<u32>(0u),
    );
    return select(size, -size, (bits & vec4<u32>(0x8000u)) != vec4<u32>(0u));
}

// Channels 4 group to 4 group + 3 of a texel; texel = row * resolution + column.
fn rna_texel(plane: u32, texel: u32, group: u32) -> vec4f {
    let count = 4u >> rna_part.plane_precision; // words of four channels
    let at = count * (texel * rna_part.channel_groups + group);
    var words = vec4<u32>(0u);
    for (var k = 0u; k < count; k++) {
        words[k] = rna_plane_word(plane, at + k);
    }
    switch rna_part.plane_precision {
        case RNA_FLOAT32: {
            return bitcast<vec4f>(words);
        }
        case RNA_FLOAT16: {
            let halves = vec4<u32>(words.x, words.x >> 16u, words.y, words.y >> 16u);
            return rna_from_float16(halves & vec4<u32>(0xffffu));
        }
        default: {
            let high = words.xxxx << vec4<u32>(24u, 16u, 8u, 0u);
            let integers = bitcast<vec4<i32>>(high) >> vec4<u32>(24u);
            return vec4f(integers) * rna_part.scales[plane * RNA_CHANNEL_GROUPS + group];
        }
    }
}

// Where a position is on one axis: texel, the next one, and the fraction between them.
struct RnaTexel {
    low: vec3<u32>,
    high: vec3<u32>,
    fraction: vec3f,
}

fn rna_texels(p: vec3f) -> RnaTexel {
    let last = f32(rna_part.resolution - 1u);
    let s = clamp(p * f32(rna_part.resolution) - 0.5, vec3f(0.0), vec3f(last));
    let below = floor(s);
    let low = vec3<u32>(below);
    let high = min(low + vec3<u32>(1u), vec3<u32>(rna_part.resolution - 1u));
    return RnaTexel(low, high, s - below);
}

// x: (texel, next) along the columns, y: along the rows.
fn rna_bilinear(
    plane: u32, group: u32, columns: vec2<u32>, rows: vec2<u32>, a: f32, b: f32,
) -> vec4f {
    var sum = vec4f(0.0);
    for (var row = 0u; row < 2u; row++) {
        var along = vec4f(0.0);
        for (var column = 0u; column < 2u; column++) {
            let texel = rows[row] * rna_part.resolution + columns[column];
            along += select(1.0 - a, a, column == 1u) * rna_texel(plane, texel, group);
        }
        sum += select(1.0 - b, b, row == 1u) * along;
    }
    return sum;
}

// Position as a fraction of the bounds, clamped to them.
fn rna_relative(x: vec3f) -> vec3f {
    let inside = clamp(x, rna_part.low, rna_part.high);
    return clamp((inside - rna_part.low) / (rna_part.high - rna_part.low), vec3f(0.0), vec3f(1.0));
}

// Channels 4 group to 4 group + 3 of the features at p, in [0, 1].
fn rna_features(t: RnaTexel, group: u32) -> vec4f {
    var sum = vec4f(0.0);
    for (var plane = 0u; plane < 3u; plane++) {
        let next = (plane + 1u) % 3u;
        let columns = vec2<u32>(t.low[plane], t.high[plane]);
        let rows = vec2<u32>(t.low[next], t.high[next]);
        sum += rna_bilinear(plane, group, columns, rows, t.fraction[plane], t.fraction[next]);
    }
    return sum;
}
`,"render/base_color.wgsl":`// The base colour of an asset's hit: spec/RNA.md, 4.6. Its surface has the factor, and the image as texture BASE.

// Texture coordinates of the triangle's corners in the image.
fn corners_in_image(texture: u32, record: RnaPrimitive) -> mat3x2f {
    let uv = corner_uvs(record, 0u);
    return mat3x2f(
        image_place(texture, uv[0]), image_place(texture, uv[1]), image_place(texture, uv[2]),
    );
}

// place: in the image.
fn base_color_at(surface: u32, place: vec2f, level: f32) -> vec3f {
    let image = image_of(surface_textures(surface, BASE));
    return surface_base_color(surface) * rna_image_color_at(image, place, level);
}

fn base_color_of_level(record: RnaPrimitive, b1: f32, b2: f32, level: f32) -> vec3f {
    let surface = rna_surface(record);
    let texture = surface_textures(surface, BASE);
    if texture == NONE {
        return surface_base_color(surface);
    }
    return base_color_at(surface, corners_in_image(texture, record) * weights_of(b1, b2), level);
}

// width: of a pixel at the hit, object space; 0 for the image as it is.
fn base_color_on(record: RnaPrimitive, b1: f32, b2: f32, width: f32) -> vec3f {
    let surface = rna_surface(record);
    let texture = surface_textures(surface, BASE);
    if texture == NONE {
        return surface_base_color(surface);
    }
    let p = mat3x3f(rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz);
    let uv = corners_in_image(texture, record);
    let level = rna_level_for(image_of(texture), p, uv, width);
    return base_color_at(surface, uv * weights_of(b1, b2), level);
}
`,"render/bumps.wgsl":`// Normals of materials with the relief of a normal texture: rna_render/materials/bumps.py.

const MIN_MIRROR_COSINE: f32 = 0.01;

fn unit_or_zero(v: vec3f) -> vec3f {
    let size = length(v);
    return select(vec3f(0.0), v / max(size, 1e-30), size > 0.0);
}

fn point_tangent(base: u32, point: u32) -> vec4f {
    let at = base + 4u * point;
    return bitcast<vec4f>(vec4<u32>(images[at], images[at + 1u], images[at + 2u], images[at + 3u]));
}

// The file's tangent, interpolated, and the bitangent's sign; a sign of 0 where a corner has none.
fn given_tangent(record: RnaPrimitive, b: vec3f) -> vec4f {
    let base = surface_tangents(rna_surface(record));
    if base == NONE {
        return vec4f(0.0);
    }
    let first = point_tangent(base, record.a);
    let second = point_tangent(base, record.b);
    let third = point_tangent(base, record.c);
    let all_there = first.w != 0.0 && second.w != 0.0 && third.w != 0.0;
    let t = b.x * first.xyz + b.y * second.xyz + b.z * third.xyz;
    return vec4f(t, select(0.0, first.w, all_there));
}

// The direction of u on the triangle, and the sign that makes the bitangent go against v.
fn derived_tangent(record: RnaPrimitive, uv: mat3x2f, n: vec3f) -> vec4f {
    let p = rna_points[record.a].xyz;
    let e1 = rna_points[record.b].xyz - p;
    let e2 = rna_points[record.c].xyz - p;
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = select(1.0, -1.0, area < 0.0);
    let along_u = side * (d2.y * e1 - d1.y * e2);
    let along_v = side * (d1.x * e2 - d2.x * e1);
    let sign = select(1.0, -1.0, dot(cross(n, along_u), along_v) > 0.0);
    return vec4f(along_u, select(0.0, sign, area != 0.0));
}

// m, or the nearest normal that mirrors o above the surface; g is on o's side.
fn raised_above(m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let mirror = 2.0 * dot(m, o) * m - o;
    let missing = min(0.9 * dot(g, o), MIN_MIRROR_COSINE) - dot(g, mirror);
    if missing <= 0.0 {
        return m;
    }
    return unit_or_zero(o + unit_or_zero(mirror + missing * g));
}

// The normal m with the relief of its material's normal texture; g, o: geometric normal and unit
// direction to the viewer.
fn bumped_normal(record: RnaPrimitive, b1: f32, b2: f32, m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let texture = surface_textures(rna_surface(record), RELIEF);
    if texture == NONE {
        return m;
    }
    let uvs = corner_uvs(record, (image_of(texture).form >> 5u) & 1u);
    let b = weights_of(b1, b2);
    var tangent = given_tangent(record, b);
    if tangent.w == 0.0 {
        tangent = derived_tangent(record, uvs, m);
    }
    let t = unit_or_zero(tangent.xyz - dot(tangent.xyz, m) * m);
    if tangent.w == 0.0 || dot(t, t) == 0.0 {
        return m;
    }
    let scale = surface_normal_scale(rna_surface(record));
    let relief = 2.0 * texture_value(texture, uvs * b) - 1.0;
    let bitangent = tangent.w * cross(m, t);
    let bent = unit_or_zero(relief.z * m + scale * (relief.x * t + relief.y * bitangent));
    // All on the side of the surface that o is on, and back.
    let side = select(1.0, -1.0, dot(g, o) < 0.0);
    let side_of_m = select(-side, side, dot(m, g) >= 0.0);
    return side_of_m * raised_above(side_of_m * bent, side * g, o);
}
`,"render/directions.wgsl":`// Directions about an axis.

const SPHERE_PDF: f32 = 1.0 / (4.0 * PI);

struct Tangents {
    s: vec3f,
    t: vec3f,
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
fn tangents_of(n: vec3f) -> Tangents {
    let sign = select(1.0, -1.0, n.z < 0.0);
    let c = -1.0 / (sign + n.z);
    let d = n.x * n.y * c;
    return Tangents(
        vec3f(1.0 + sign * n.x * n.x * c, sign * d, -sign * n.x),
        vec3f(d, sign + n.y * n.y * c, -n.y),
    );
}

fn about(axis: vec3f, sine: f32, cosine: f32, turns: f32) -> vec3f {
    let frame_of = tangents_of(axis);
    let phi = 2.0 * PI * turns;
    return sine * cos(phi) * frame_of.s + sine * sin(phi) * frame_of.t + cosine * axis;
}

fn along_axis(axis: vec3f, cosine: f32, turns: f32) -> vec3f {
    return about(axis, sqrt(max(0.0, 1.0 - cosine * cosine)), cosine, turns);
}

// Cosine to the axis of a von Mises-Fisher direction.
fn fisher_cosine(u: f32, kappa: f32) -> f32 {
    return max(-1.0, 1.0 + log(u + (1.0 - u) * exp(-2.0 * kappa)) / kappa);
}

fn fisher_pdf(cosine: f32, kappa: f32) -> f32 {
    return kappa * exp(kappa * (cosine - 1.0)) / (2.0 * PI * (1.0 - exp(-2.0 * kappa)));
}

// Uniform within a cone about a unit axis, by 1 - cos of the angle to its rim.
fn cone_direction(axis: vec3f, one_minus_cosine: f32, u: vec2f) -> vec3f {
    let height = u.x * one_minus_cosine;
    return about(axis, sqrt(max(0.0, height * (2.0 - height))), 1.0 - height, u.y);
}
`,"render/environment.wgsl":`// An equirectangular image: see rna_render/lights/equirectangular.py and image_kernels.py, which this follows. In \`images\`
// a light has texels (h, w, 3), heights (h + 1), running sums of rows (h + 2) and of each row's cells
// (h + 1, w + 1).

struct Cell {
    corners: mat4x3f,
    luminances: vec4f,
}

fn image_float(at: u32) -> f32 {
    return bitcast<f32>(images[at]);
}

fn luminance(c: vec3f) -> f32 {
    return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

fn image_size(light: u32) -> vec2<u32> {
    return vec2<u32>(u32(image_rows(light)), u32(image_columns(light)));
}

fn image_texel(light: u32, row: u32, column: u32) -> vec3f {
    let at = image_texels(light) + 3u * (row * image_size(light).y + column);
    return vec3f(image_float(at), image_float(at + 1u), image_float(at + 2u));
}

fn image_cell(light: u32, row: u32, column: u32) -> Cell {
    let size = image_size(light);
    let upper = max(row, 1u) - 1u;
    let lower = min(row, size.x - 1u);
    let right = select(0u, column + 1u, column + 1u < size.y);
    var cell: Cell;
    for (var k = 0u; k < 4u; k++) {
        let texel = image_texel(light, select(upper, lower, k > 1u), select(column, right, (k & 1u) == 1u));
        cell.corners[k] = texel;
        cell.luminances[k] = luminance(texel);
    }
    return cell;
}

fn in_cell(cell: Cell, x: f32, y: f32) -> vec3f {
    return cell.corners * vec4f((1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y);
}

// The interval of running sums from \`at\` on, \`count\` of them, that a value is in, by bisection.
fn interval(at: u32, count: u32, value: f32) -> u32 {
    var low = 0u;
    var high = count;
    while high - low > 1u {
        let middle = (low + high) / 2u;
        if image_float(at + middle) <= value {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

fn place_within(at: u32, k: u32, value: f32) -> f32 {
    let size = image_float(at + k + 1u) - image_float(at + k);
    if size <= 0.0 {
        return 0.0;
    }
    return clamp((value - image_float(at + k)) / size, 0.0, 0.99999994);
}

// A place in [0, 1] with density in proportion to a line from a to b.
fn sample_linear(a: f32, b: f32, u: f32) -> f32 {
    let root = sqrt(max(a * a + u * (b * b - a * a), 0.0));
    if a + root <= 0.0 {
        return u;
    }
    return u * (a + b) / (a + root);
}

fn image_density(light: u32, row: u32, sine: f32, here: f32, mean_here: f32) -> f32 {
    let total = image_total(light);
    let mean = image_mean(light);
    if total <= 0.0 {
        return 0.0;
    }
    let size = image_size(light);
    var pdf = here * f32(size.y) / (2.0 * PI * total);
    if mean > 0.0 {
        pdf *= max(mean_here - mean, 0.0) / max(mean_here, 1e-30);
    }
    if row > 0u && row < size.x {
        let height = image_float(image_heights(light) + row);
        pdf *= height * f32(size.x) / (PI * max(sine, 1e-30));
    }
    return pdf;
}

// Where in a cell of that row, down from the middles above.
fn sample_down(light: u32, row: u32, l: vec4f, u: f32) -> f32 {
    let h = image_size(light).x;
    let height = image_float(image_heights(light) + row);
    let cap = 2.0 * asin(sqrt(u * height / 2.0)) / PI * f32(h);
    if row == 0u {
        return cap + 0.5;
    }
    if row == h {
        return 0.5 - cap;
    }
    return sample_linear(l.x + l.y, l.z + l.w, u);
}

fn sample_image(light: u32, u: vec2f) -> LightSample {
    let size = image_size(light);
    let rows = image_row_sums(light);
    let down = u.y * image_float(rows + size.x + 1u);
    let row = interval(rows, size.x + 1u, down);
    let columns = image_column_sums(light) + row * (size.y + 1u);
    let across = u.x * image_float(columns + size.y);
    let column = interval(columns, size.y, across);
    let cell = image_cell(light, row, column);
    let l = cell.luminances;
    let y = sample_down(light, row, l, place_within(rows, row, down));
    let left = mix(l.x, l.z, y);
    let x = sample_linear(left, mix(l.y, l.w, y), place_within(columns, column, across));
    let theta = PI * (f32(row) - 0.5 + y) / f32(size.x);
    let phi = 2.0 * PI * ((f32(column) + 0.5 + x) / f32(size.y) - 0.5);
    let sine = sin(theta);
    let away = sine * sin(phi);
    let along = -sine * cos(phi);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let wi = vec3f(turn.x * away + turn.y * along, cos(theta), turn.x * along - turn.y * away);
    let radiance = in_cell(cell, x, y);
    let pdf = image_density(light, row, sine, luminance(radiance), dot(l, vec4f(0.25)));
    return light_sample(wi, RNA_FAR, light_colour(light) * radiance, pdf);
}

fn look_up_image(light: u32, d: vec3f) -> LightHit {
    let size = image_size(light);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let x = turn.x * d.x - turn.y * d.z;
    let z = turn.y * d.x + turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    var azimuth = 0.0;
    if sine > 0.0 {
        azimuth = atan2(x, -z);
    }
    let s = (0.5 + azimuth / (2.0 * PI)) * f32(size.y) - 0.5;
    let t = atan2(sine, d.y) / PI * f32(size.x) + 0.5;
    let row = u32(clamp(floor(t), 0.0, f32(size.x)));
    let left = floor(s);
    let column = select(size.y - 1u, u32(max(left, 0.0)), left >= 0.0 && left < f32(size.y));
    let cell = image_cell(light, row, column);
    let radiance = in_cell(cell, s - left, t - f32(row));
    let mean = dot(cell.luminances, vec4f(0.25));
    let pdf = image_density(light, row, sine, luminance(radiance), mean);
    return LightHit(light_colour(light) * radiance, pdf);
}
`,"render/frame.wgsl":`// What all steps of the renderer share: the step's numbers, paths, sums, and tables.

const PI: f32 = 3.14159265358979;
const SHORTER: f32 = 1.0 - 0x1p-13f; // shadow rays end before the light

const DEAD: u32 = 0u;
const ALIVE: u32 = 1u;
const BENT: f32 = 0x1p100f; // density of directions that no sample of a light finds: those behind solid glass

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> queries: array<PathQueries>;
@group(0) @binding(4) var<storage, read> table: array<vec4f>;
@group(0) @binding(5) var<storage, read> images: array<u32>; // floats of skies, bytes of textures

fn path_number(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.y * groups.x * 64u + id.x;
}

fn add_light(k: u32, light: u32, radiance: vec3f) {
    let at = frame.sums * k;
    sums[at + SUM_BEAUTY] += vec4f(radiance, 0.0);
    let group = light_group(light);
    if group != NONE {
        sums[at + SUM_GROUPS + 2u * group] += vec4f(radiance, 0.0);
    }
}

// Clamped after two or more scatterings.
fn clamped(radiance: vec3f) -> vec3f {
    if frame.clamp <= 0.0 || frame.depth < 2u {
        return radiance;
    }
    let largest = max(max(radiance.x, max(radiance.y, radiance.z)), 1e-30);
    return radiance * (min(frame.clamp, largest) / largest);
}

// Power heuristic: the part of the estimate that belongs to the first way.
fn share(pdf: f32, other: f32) -> f32 {
    if pdf <= 0.0 {
        return 0.0;
    }
    let ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}
`,"render/ggx.wgsl":`// The GGX microfacet surface, as rna_render.materials.ggx has it.

// D, of the squared sine and the cosine of the half vector to the normal.
fn distribution(alpha: f32, sine2: f32, nh: f32) -> f32 {
    let a2 = alpha * alpha;
    let spread = sine2 + a2 * nh * nh;
    return a2 / (PI * spread * spread);
}

fn smith_root(alpha: f32, cosine: f32) -> f32 {
    return sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

struct Half {
    sine2: f32,
    nh: f32,
    oh: f32,
}

fn half_of(m: vec3f, o: vec3f, i: vec3f) -> Half {
    let sum = o + i;
    let size = length(sum);
    if size < 1e-6 {
        return Half(1.0, 0.0, 0.0);
    }
    let h = sum / size;
    let aside = cross(m, h);
    return Half(dot(aside, aside), min(dot(m, h), 1.0), dot(o, h));
}

// Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps (HPG 2023).
fn sample_reflection(alpha: f32, o: vec3f, u: vec2f) -> vec3f {
    let s = normalize(vec3f(alpha * o.x, alpha * o.y, o.z));
    let phi = 2.0 * PI * u.x;
    let z = (1.0 - u.y) * (1.0 + s.z) - s.z;
    let radius = sqrt(max(0.0, 1.0 - z * z));
    let h = vec3f(alpha * (radius * cos(phi) + s.x), alpha * (radius * sin(phi) + s.y), z + s.z);
    let size = length(h);
    let n = select(vec3f(0.0, 0.0, 1.0), h / max(size, 1e-30), size > 0.0);
    return 2.0 * dot(o, n) * n - o;
}

// Of sample_reflection about m.
fn reflected_density(alpha: f32, m: vec3f, o: vec3f, i: vec3f) -> f32 {
    let h = half_of(m, o, i);
    if h.nh <= 0.0 {
        return 0.0;
    }
    let cos_o = dot(m, o);
    return distribution(alpha, h.sine2, h.nh) / (2.0 * (cos_o + smith_root(alpha, cos_o)));
}
`,"render/light_shapes.wgsl":`// Lights with a shape, which rays meet.

// The hit, or a nearer one of a light with a shape.
fn with_lights(ray: RnaRay, rays: u32, of_geometry: RnaHit) -> RnaHit {
    var hit = of_geometry;
    for (var light = 0u; light < frame.light_count; light++) {
        let hidden = rays == CAMERA_RAY && !light_is(light, LIGHT_SEEN);
        let t = meet_light(light, RnaRay(ray.origin, ray.near, ray.direction, hit.t));
        if !hidden && t < RNA_FAR && (hit.instance == RNA_NOTHING || t < hit.t) {
            hit = rna_miss(t);
            hit.instance = IS_LIGHT | light;
        }
    }
    return hit;
}
`,"render/lights.wgsl":`// Lights: samples of them, and their radiance and density at hits of rays. They are those of rna_render.lights.

const MAX_PDF: f32 = 1e18;
const MIN_SOLID_ANGLE: f32 = 1e-3; // float32 knows no smaller one to 1e-3 of itself

struct LightSample {
    wi: vec3f,
    distance: f32,
    radiance: vec3f, // of an asset's triangles a factor on what they emit
    pdf: f32,
    primitive: u32, // of triangles
    b1: f32,
    b2: f32,
}

fn light_sample(wi: vec3f, distance: f32, radiance: vec3f, pdf: f32) -> LightSample {
    return LightSample(wi, distance, radiance, pdf, NONE, 0.0, 0.0);
}

// A light along a ray: its radiance, and the density of sampling it there.
struct LightHit {
    radiance: vec3f,
    pdf: f32,
}

// Samples that a light gets at a point, on average.
fn samples_of(light: u32, depth: u32) -> f32 {
    return light_probability(light)[min(depth, 3u) - 1u];
}

fn light_is(light: u32, flag: u32) -> bool {
    return (light_flags(light) & flag) != 0u;
}

// Of points of a plane: per_area, seen along d; 0 from behind.
fn flat_pdf(point: vec3f, normal: vec3f, per_area: f32, x: vec3f, d: vec3f) -> f32 {
    let cosine = -dot(d, normal);
    let height = dot(x - point, normal);
    if cosine <= 0.0 || height <= 0.0 {
        return 0.0;
    }
    let t = height / cosine;
    let pdf = per_area * t * t / cosine;
    return select(0.0, pdf, pdf < MAX_PDF);
}

fn edge_angle(x: f32, y: f32, sign: f32, height: f32) -> f32 {
    return atan2(height * sqrt(x * x + y * y + height * height), sign * x * y);
}

// Solid angle of a rectangle from (x0, y0) to (x1, y1), and the sum k of Ure\xF1a, Fajardo and King,
// An Area-Preserving Parametrization for Spherical Rectangles (EGSR 2013), section 5.
fn solid_angle(e: vec4f, height: f32) -> vec2f {
    let k = 2.0 * PI - edge_angle(e.x, e.w, 1.0, height) - edge_angle(e.x, e.z, -1.0, height);
    let right = edge_angle(e.y, e.z, 1.0, height) + edge_angle(e.y, e.w, -1.0, height);
    return vec2f(right - k, k);
}

// Edges x0, x1, y0, y1 of a rectangle as seen from x.
fn rectangle_edges(light: u32, from_place: vec3f) -> vec4f {
    let a = dot(from_place, rectangle_frame(light)[0]);
    let b = dot(from_place, rectangle_frame(light)[1]);
    let half = rectangle_half(light);
    return vec4f(-half.x - a, half.x - a, -half.y - b, half.y - b);
}

fn rectangle_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let half = rectangle_half(light);
    let f = rectangle_frame(light);
    let flat = flat_pdf(f[3], f[2], 0.25 / (half.x * half.y), x, d);
    let height = dot(x - f[3], f[2]);
    let angle = solid_angle(rectangle_edges(light, x - f[3]), max(height, 1e-30)).x;
    if flat == 0.0 || angle < MIN_SOLID_ANGLE {
        return flat;
    }
    return 1.0 / angle;
}

fn rectangle_point(e: vec4f, height: f32, u: vec2f) -> vec2f {
    let angle = solid_angle(e, height);
    if angle.x < MIN_SOLID_ANGLE {
        return mix(e.xz, e.yw, u);
    }
    let b0 = -e.z / sqrt(height * height + e.z * e.z);
    let b1 = e.w / sqrt(height * height + e.w * e.w);
    let turn = u.x * angle.x + angle.y;
    let sine = sin(turn);
    let f = (cos(turn) * b0 - b1) / select(sine, 1e-20, abs(sine) < 1e-20);
    let c = clamp(select(-1.0, 1.0, f >= 0.0) / sqrt(f * f + b0 * b0), -1.0, 1.0);
    let x = clamp(c * height / sqrt(max(1.0 - c * c, 1e-20)), e.x, e.y);
    let squared = x * x + height * height;
    let h0 = e.z / sqrt(squared + e.z * e.z);
    let h1 = e.w / sqrt(squared + e.w * e.w);
    let h = h0 + u.y * (h1 - h0);
    let y = h * sqrt(squared / max(1.0 - h * h, 1e-20));
    return vec2f(x, clamp(y, e.z, e.w));
}

// Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 2(3), 1997).
fn concentric(u: vec2f) -> vec2f {
    let a = 2.0 * u - 1.0;
    if a.x == 0.0 && a.y == 0.0 {
        return vec2f(0.0);
    }
    if abs(a.x) > abs(a.y) {
        let phi = PI / 4.0 * (a.y / a.x);
        return a.x * vec2f(cos(phi), sin(phi));
    }
    let phi = PI / 2.0 - PI / 4.0 * (a.x / a.y);
    return a.y * vec2f(cos(phi), sin(phi));
}

// 1 - cos of the angular radius of a sphere light; 0 from within.
fn sphere_cone(light: u32, x: vec3f) -> f32 {
    let to_centre = sphere_centre(light) - x;
    let radius = sphere_radius(light);
    let squared = dot(to_centre, to_centre);
    if squared <= radius * radius {
        return 0.0;
    }
    let sin2 = radius * radius / squared;
    return sin2 / (1.0 + sqrt(1.0 - sin2));
}

fn shape_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        return rectangle_pdf(light, x, d);
    }
    if kind == DISK {
        let radius = disk_radius(light);
        let per_area = 1.0 / (PI * radius * radius);
        return flat_pdf(disk_frame(light)[3], disk_frame(light)[2], per_area, x, d);
    }
    let cone = sphere_cone(light, x);
    return select(0.0, 1.0 / (2.0 * PI * max(cone, 1e-18)), cone > 0.0);
}

// A point of a shape, relative to x.
fn shape_point(light: u32, x: vec3f, u: vec2f) -> vec3f {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        let f = rectangle_frame(light);
        let height = dot(x - f[3], f[2]);
        if height <= 0.0 {
            return f[3] - x;
        }
        let p = rectangle_point(rectangle_edges(light, x - f[3]), height, u);
        return p.x * f[0] + p.y * f[1] - height * f[2];
    }
    if kind == DISK {
        let f = disk_frame(light);
        let p = disk_radius(light) * concentric(u);
        return f[3] + p.x * f[0] + p.y * f[1] - x;
    }
    let to_centre = sphere_centre(light) - x;
    let wi = cone_direction(normalize(to_centre), sphere_cone(light, x), u);
    let along = dot(to_centre, wi);
    let rest = to_centre - along * wi;
    let radius = sphere_radius(light);
    return (along - sqrt(max(0.0, radius * radius - dot(rest, rest)))) * wi;
}

fn sample_point(light: u32, x: vec3f) -> LightSample {
    let way = point_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, light_colour(light) / (r * r), 1.0);
}

fn sample_spot(light: u32, x: vec3f) -> LightSample {
    let way = spot_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let wi = way / r;
    let cosine = -dot(wi, spot_axis(light));
    let inner = spot_cos_inner(light);
    let outer = spot_cos_outer(light);
    var factor = 1.0;
    if cosine < inner {
        let t = clamp((cosine - outer) / max(inner - outer, 1e-20), 0.0, 1.0);
        factor = t * t * (3.0 - 2.0 * t);
    }
    let pdf = select(0.0, 1.0, factor > 0.0);
    return light_sample(wi, r, factor / (r * r) * light_colour(light), pdf);
}

fn sample_light(light: u32, x: vec3f, u: vec2f) -> LightSample {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return sample_image(light, u);
    }
    if kind == UNIFORM {
        return light_sample(
            cone_direction(vec3f(0.0, 0.0, 1.0), 2.0, u), RNA_FAR, colour, SPHERE_PDF,
        );
    }
    if kind == SUN {
        let cone = sun_one_minus_cosine(light);
        let wi = cone_direction(sun_axis(light), cone, u);
        return light_sample(wi, RNA_FAR, colour, 1.0 / (2.0 * PI * cone));
    }
    if kind == DIRECTIONAL {
        return light_sample(directional_axis(light), RNA_FAR, colour, 1.0);
    }
    if kind == TRIANGLES {
        return sample_triangles(light, x, u);
    }
    if kind == POINT {
        return sample_point(light, x);
    }
    if kind == SPOT {
        return sample_spot(light, x);
    }
    let way = shape_point(light, x, u);
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, colour, shape_pdf(light, x, way / r));
}

// An infinite light along d.
fn environment_along(light: u32, d: vec3f) -> LightHit {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return look_up_image(light, d);
    }
    if kind == UNIFORM {
        return LightHit(colour, SPHERE_PDF);
    }
    if kind == SUN {
        let off = d - sun_axis(light);
        let cone = sun_one_minus_cosine(light);
        if dot(off, off) <= 2.0 * cone {
            return LightHit(colour, 1.0 / (2.0 * PI * cone));
        }
    }
    return LightHit(vec3f(0.0), 0.0);
}

// Where a ray meets the plane of a flat light; RNA_FAR where it is along it.
fn meet_plane(f: mat4x3f, ray: RnaRay) -> f32 {
    let down = dot(ray.direction, f[2]);
    if abs(down) < 1e-20 {
        return RNA_FAR;
    }
    return dot(f[3] - ray.origin, f[2]) / down;
}

// The ray's position there, along the light's axes.
fn on_plane(f: mat4x3f, ray: RnaRay, t: f32) -> vec2f {
    let p = ray.origin + t * ray.direction - f[3];
    return vec2f(dot(p, f[0]), dot(p, f[1]));
}

// Where a ray meets the shape of a light; RNA_FAR where it does not.
fn meet_light(light: u32, ray: RnaRay) -> f32 {
    let kind = light_kind(light);
    var t = RNA_FAR;
    if kind == SPHERE {
        let centre = sphere_centre(light);
        let radius = sphere_radius(light);
        t = rna_enter_sphere(ray.origin, ray.direction, centre, radius);
        let from_centre = ray.origin - centre;
        if dot(from_centre, from_centre) < radius * radius && t < RNA_FAR {
            t = -t - 2.0 * dot(from_centre, ray.direction);
        }
    } else if kind == RECTANGLE {
        let f = rectangle_frame(light);
        t = meet_plane(f, ray);
        let p = abs(on_plane(f, ray, t));
        t = select(RNA_FAR, t, all(p <= rectangle_half(light)));
    } else if kind == DISK {
        let f = disk_frame(light);
        t = meet_plane(f, ray);
        t = select(RNA_FAR, t, length(on_plane(f, ray, t)) <= disk_radius(light));
    }
    return select(RNA_FAR, t, t >= ray.near && t < ray.far);
}
`,"render/lobes.wgsl":`// Directions for rays that leave a neural asset: the mixtures of rna_render.world.neural_sampling, which
// says why.

// shares: of the broad lobe (cosine of surfaces, forward of fibers) and of narrow ones (mirror, cone); all
// directions alike have what they leave.
struct Lobes {
    is_fiber: bool,
    shares: vec4f,
    widths: vec4f,
}

struct LobeFrame {
    o: vec3f,
    normal: vec3f, // turned to the viewer
    tangent: vec3f,
}

fn unit_or_up(v: vec3f) -> vec3f {
    let size = length(v);
    if size <= 0.5 {
        return vec3f(0.0, 1.0, 0.0);
    }
    return v / size;
}

fn lobe_frame(n: vec3f, tangent: vec3f, o: vec3f) -> LobeFrame {
    var normal = unit_or_up(n);
    if dot(normal, o) < 0.0 {
        normal = -normal;
    }
    return LobeFrame(o, normal, unit_or_up(tangent));
}

fn logistic(x: f32) -> f32 {
    return 1.0 / (1.0 + exp(-x));
}

fn lobe_cone_sine(u: f32, middle: f32, scale: f32) -> f32 {
    let low = logistic((-1.0 - middle) / scale);
    let high = logistic((1.0 - middle) / scale);
    let p = clamp(low + u * (high - low), 1e-7, 1.0 - 1e-7);
    return clamp(middle + scale * log(p / (1.0 - p)), -1.0, 1.0);
}

fn lobe_cone_pdf(sine: f32, middle: f32, scale: f32) -> f32 {
    let low = logistic((-1.0 - middle) / scale);
    let high = logistic((1.0 - middle) / scale);
    let p = logistic((sine - middle) / scale);
    return p * (1.0 - p) / (scale * (high - low) * 2.0 * PI);
}

fn lobe_mirrored(at: LobeFrame, alpha: f32, u: vec2f) -> vec3f {
    let local = tangents_of(at.normal);
    let o = vec3f(dot(local.s, at.o), dot(local.t, at.o), dot(at.normal, at.o));
    let i = sample_reflection(alpha, o, u.yx);
    return i.x * local.s + i.y * local.t + i.z * at.normal;
}

// u.x chooses the lobe, and what is left of it the direction there.
fn lobe_sample(at: LobeFrame, lobes: Lobes, u: vec2f) -> vec3f {
    var left = u.x;
    for (var k = 0u; k < 4u; k++) {
        let share = lobes.shares[k];
        if left < share {
            return normalize(lobe_direction(at, lobes, k, vec2f(left / share, u.y)));
        }
        left -= share;
    }
    let rest = max(1.0 - dot(lobes.shares, vec4f(1.0)), 1e-6);
    return normalize(along_axis(at.normal, 1.0 - 2.0 * min(left / rest, 1.0), u.y));
}

fn lobe_direction(at: LobeFrame, lobes: Lobes, k: u32, u: vec2f) -> vec3f {
    let width = lobes.widths[k];
    if !lobes.is_fiber {
        if k == 0u {
            return along_axis(at.normal, sqrt(1.0 - u.x), u.y);
        }
        return lobe_mirrored(at, width, u);
    }
    if k == 0u {
        return along_axis(-at.o, fisher_cosine(u.x, 1.0 / (width * width)), u.y);
    }
    return along_axis(at.tangent, lobe_cone_sine(u.x, -dot(at.tangent, at.o), width), u.y);
}

fn lobe_density(at: LobeFrame, lobes: Lobes, w: vec3f) -> f32 {
    var density = max(1.0 - dot(lobes.shares, vec4f(1.0)), 0.0) * SPHERE_PDF;
    if lobes.is_fiber {
        let width = lobes.widths.x;
        density += lobes.shares.x * fisher_pdf(-dot(at.o, w), 1.0 / (width * width));
    } else {
        density += lobes.shares.x * max(0.0, dot(at.normal, w)) / PI;
    }
    for (var k = 1u; k < 4u; k++) {
        let share = lobes.shares[k];
        let width = lobes.widths[k];
        if share > 0.0 && lobes.is_fiber {
            density += share * lobe_cone_pdf(dot(at.tangent, w), -dot(at.tangent, at.o), width);
        } else if share > 0.0 {
            density += share * reflected_density(width, at.normal, at.o, w);
        }
    }
    return density;
}
`,"render/nearby_light.wgsl":`// Nearby light by one column: spec/RNA.md, 7.3, and rna_trace/nearby.py, which draws the same.

const COLUMNS_BEGIN: f32 = 2.0; // of distant light, times the diagonal of the asset
const OF_LENGTHS: f32 = 1.2; // median of rho, times the geometric mean of the outer lengths
const SHAPE: f32 = 1.5; // of the distribution of rho

// x, wi, far (the distance of the light): object space of the body below \`root\`. u: from 0 to 1. A host whose triangles
// let light through says which of them columns pass.
fn nearby_light(root: u32, lengths: vec3f, x: vec3f, wi: vec3f, far: f32, u: vec2f) -> vec3f {
    let share = clamp(u.x, 0x1p-24f, 1.0 - 0x1p-24f);
    let rho = OF_LENGTHS * sqrt(lengths.x) * sqrt(lengths.z) * pow(share / (1.0 - share), 1.0 / SHAPE);
    let phi = 2.0 * PI * u.y;
    let axes = tangents_of(wi);
    let reach = min(far, COLUMNS_BEGIN * distance(rna_nodes[root].low, rna_nodes[root].high));
    let origin = x + rho * (cos(phi) * axes.s + sin(phi) * axes.t) + reach * wi;
    var hit = rna_miss(RNA_FAR);
    if !rna_trace_body(root, RnaRay(origin, 0.0, -wi, RNA_FAR), RNA_NOTHING, false, &hit) {
        return vec3f(0.0);
    }
    let beside = vec3f(rho) / lengths;
    let far_away = vec3f(length(vec2f(rho, reach - hit.t))) / lengths;
    return exp(-far_away) * beside * beside / (SHAPE * share * (1.0 - share));
}
`,"render/passing.wgsl":`// What rays pass through: rna_trace/embree/filters.py. Rays pass hits at random, as often as these
// let light through; shadow rays pass all and are weakened; columns of nearby light pass what lets through most.

const ALL_STOP: u32 = 0u;
const AT_RANDOM: u32 = 1u; // the mean of the colours
const WEAKEN: u32 = 2u;
const WEIGH: u32 = 3u; // stops at nothing; colour over mean of what AT_RANDOM has passed
const PASS_MOST: u32 = 4u; // what lets through half of the light or more: spec/RNA.md, 7.3

var<private> passing: u32;
var<private> passed_weight: vec3f;
var<private> is_coloured: bool;
var<private> stopped_share: vec3f; // of the last hit that stopped: what colours it leaves
var<private> chance_key: u32;

fn start_passing(how: u32) {
    passing = select(ALL_STOP, how, (frame.flags & TRANSMITS) != 0u);
    passed_weight = vec3f(1.0);
    is_coloured = false;
}

// In [0, 1), a fixed number for each primitive and ray.
fn chance(primitive: u32, instance: u32) -> f32 {
    let state = hash_bits(hash_bits(chance_key ^ primitive) + instance);
    return f32(state >> 8u) * 0x1p-24f;
}

fn pass_at_random(tau: vec3f, mean: f32, passes: bool) -> bool {
    let coloured = any(tau != vec3f(tau.x));
    if passes {
        is_coloured = is_coloured || coloured;
        return false;
    }
    stopped_share = select(vec3f(1.0), (1.0 - tau) / max(1.0 - mean, 1e-6), coloured);
    return true;
}

fn rna_stops(primitive: u32, ray: RnaRay, crossing: vec3f, instance: u32) -> bool {
    stopped_share = vec3f(1.0);
    if passing == ALL_STOP {
        return true;
    }
    let record = rna_primitives[primitive];
    if !surface_has(rna_surface(record), LETS_THROUGH) {
        return passing != WEIGH;
    }
    let p = rna_points[record.a].xyz;
    let ng = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let facing = dot(ng, ray.direction) < 0.0;
    let tau = transmittance(record, crossing.y, crossing.z, ray.direction, facing);
    if passing == WEAKEN {
        passed_weight *= tau;
        return all(passed_weight <= vec3f(0.0));
    }
    let mean = (tau.x + tau.y + tau.z) / 3.0;
    if passing == PASS_MOST {
        return mean < 0.5;
    }
    let passes = mean > 0.0 && chance(primitive, instance) < mean;
    if passing == AT_RANDOM {
        return pass_at_random(tau, mean, passes);
    }
    if passes {
        passed_weight *= tau / mean;
    }
    return false;
}
`,"render/sampler.wgsl":`// Owen-scrambled Sobol' points, the very ones of rna_render.paths.sampling: a pure function of seed, pixel,
// sample and dimension.

fn hash_bits(value: u32) -> u32 {
    var x = (value ^ (value >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

// Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020).
fn owen(value: u32, seed: u32) -> u32 {
    var x = reverseBits(value) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverseBits(x);
}

fn second_sobol(index: u32) -> u32 {
    var x = reverseBits(index);
    x ^= x << 16u;
    x ^= (x & 0x00ff00ffu) << 8u;
    x ^= (x & 0x0f0f0f0fu) << 4u;
    x ^= (x & 0x33333333u) << 2u;
    return x ^ ((x & 0x55555555u) << 1u);
}

// A point of the unit square for a dimension of the path at its present point.
fn square(pixel: u32, dimension: u32, number: u32) -> vec2f {
    let image_key = hash_bits(hash_bits(frame.seed) + dimension);
    let key = hash_bits(image_key ^ hash_bits(pixel + 1u));
    let index = owen(number, key);
    let first = owen(reverseBits(index), hash_bits(key + 1u));
    let second = owen(second_sobol(index), hash_bits(key + 2u));
    return vec2f(f32(first >> 8u), f32(second >> 8u)) * 0x1p-24f;
}

// Number of the path among all of its pixel that have come to this point.
fn path_of_pixel() -> u32 {
    return frame.sample * frame.branches + frame.branch;
}

fn at_point(pixel: u32, dimension: u32) -> vec2f {
    return square(pixel, (frame.depth - 1u) * DIMENSIONS + dimension, path_of_pixel());
}

// For the sample of a light that the step is about, or its nearby light.
fn at_light_sample(pixel: u32, dimension: u32) -> vec2f {
    let which = select(frame.light, 0u, frame.light == NONE);
    let of_light = (frame.depth - 1u) * DIMENSIONS + dimension + which;
    return square(pixel, of_light, path_of_pixel() * frame.parts + frame.part);
}

// What a path's next ray passes at random through.
fn chance_of(pixel: u32) -> u32 {
    let path = hash_bits(hash_bits(frame.seed + 1u) ^ hash_bits(pixel + 1u));
    return hash_bits(hash_bits(path ^ path_of_pixel()) + frame.depth);
}
`,"render/scene_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const NONE: u32 = 0xffffffffu;
const SUM_BEAUTY: u32 = 0u;
const SUM_NORMAL: u32 = 1u;
const SUM_POSITION: u32 = 2u;
const SUM_LIGHT_SAMPLES: u32 = 3u;
const SUM_BEHIND: u32 = 4u;
const IS_LIGHT: u32 = 0x80000000u;
const MATERIAL_PART: u32 = 0xfffffffeu;
const CATCHER_PART: u32 = 0xfffffffdu;
const SUM_GROUPS: u32 = 5u;
const CAMERA_RAY: u32 = 1u;
const INDIRECT_RAY: u32 = 2u;
const SHADOW_RAY: u32 = 4u;
const ALL_DIRECTIONS: u32 = 0xffffffffu;
const HEMISPHERE: u32 = 0xfffffffeu;
const CHOICES: u32 = 1u;
const DIRECTION: u32 = 2u;
const ROULETTE: u32 = 3u;
const LIGHT: u32 = 4u;
const NEARBY: u32 = 0x200000u;
const LENS: u32 = 0x100000u;
const DIMENSIONS: u32 = 7u;
const HAS_SKY: u32 = 1u;
const FOR_BETA: u32 = 2u;
const RAYS_MEET_LIGHTS: u32 = 4u;
const FOR_EMISSION: u32 = 8u;
const FOR_LIGHT: u32 = 16u;
const TRANSMITS: u32 = 32u;
const FOR_VISIBLE: u32 = 64u;
const FOR_SHADOWED: u32 = 128u;

struct Frame { // 208 bytes
    camera: vec3f, // 0
    width: u32, // 12
    corner: vec3f, // 16; direction through the image's top left corner
    paths: u32, // 28
    step_x: vec3f, // 32; of a pixel
    sample: u32, // 44
    step_y: vec3f, // 48
    seed: u32, // 60
    depth: u32, // 64; points of the path so far
    light: u32, // 68; that is sampled; NONE: one that is chosen
    part: u32, // 72; number of the sample of this light at this point
    parts: u32, // 76; samples of this light at this point
    rays: u32, // 80; bit of the sort of rays
    clamp: f32, // 84
    light_count: u32, // 88
    sums: u32, // 92; vec4f of a path in \`sums\`: SUM_GROUPS, and two a group of lights
    flags: u32, // 96; of those below
    branch: u32, // 100; number of the ray that went on from the first point
    branches: u32, // 104; of those rays; 1 before them
    neural_part: u32, // 108
    list: u32, // 112; start in \`live\` of the list of paths that the step is for
    next_list: u32, // 116; likewise, of those that go on from there
    table_size: u32, // 120; of albedo
    objects: u32, // 124; this and the rest: starts of the sections of \`table\`
    surfaces: u32, // 128
    lights: u32, // 132
    albedo: u32, // 136
    domains: u32, // 140
    textures: u32, // 144
    spread: f32, // 148; width of a pixel over the distance to it
    lens_x: vec3f, // 160; to the right, as long as the lens's radius
    focus: f32, // 172; distance of the sharp plane; 0 of a pinhole
    lens_y: vec3f, // 176; likewise, up
    lengths: vec3f, // 192; of the nearby light that neural_part counts; object space
}

struct Path { // 96 bytes
    origin: vec3f, // 0
    pixel: u32, // 12
    direction: vec3f, // 16
    pdf: f32, // 28; of the direction; 0 of camera rays
    beta: vec3f, // 32
    state: u32, // 44
    normal: vec3f, // 48; of a segment
    t: f32, // 60
    instance: u32, // 64
    primitive: u32, // 68
    ignored: u32, // 72; instance that the ray passes through
    b1: f32, // 76
    leaving: vec3f, // 80; of a ray that leaves an asset: its start in object space
    b2: f32, // 92
}

struct Query { // 128 bytes
    x: vec3f, // 0
    h: f32, // 12
    axis: vec3f, // 16
    part: u32, // 28; whose decoder answers, or NONE, MATERIAL_PART, CATCHER_PART
    wo: vec3f, // 32
    light: u32, // 44
    wi: vec3f, // 48
    strand: u32, // 60; that a ray from here passes through
    weight: vec3f, // 64
    seen: f32, // 76; mean of what all that is in the way leaves of the light
    visible: vec3f, // 80; what the asset itself leaves of it
    far: f32, // 92; distance of the light, object space; RNA_FAR of one without
    base_color: vec3f, // 96
    nearby: vec3f, // 112; nearby light, where the part counts it
}

struct PathQueries { // 256 bytes
    at_point: Query, // 0; what the path's point scatters or emits
    at_light: Query, // 128; what an asset emits at its point that was sampled as a light
}
`,"render/solid_glass.wgsl":`// Rays through solid glass: rna_render/paths/solid_glass.py and materials/refraction.py, which this follows. No shadow
// ray passes: rays find the light that comes through.

const MOST_INTERFACES: u32 = 24u;
const INTERFACES: u32 = 0x100000u; // the first of their dimensions of random numbers

struct Followed {
    hit: RnaHit,   // of no glass
    first: f32,    // distance of the start to the first hit, of glass or not
    weight: vec3f, // what interfaces, absorption and whatever else the ray passed leave
    bent: bool,    // whether the ray has met glass
    ray: RnaRay,   // from the last interface, or the one that was given
}

// The share that is reflected. eta: index of the other side over that of this one.
fn fresnel(cos_i: f32, eta: f32) -> f32 {
    let sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
    let cos_t = sqrt(max(1.0 - sin2_t, 0.0));
    let parallel = (eta * cos_i - cos_t) / max(eta * cos_i + cos_t, 1e-30);
    let across = (cos_i - eta * cos_t) / max(cos_i + eta * cos_t, 1e-30);
    return select(0.5 * (parallel * parallel + across * across), 1.0, sin2_t >= 1.0);
}

// Where fresnel is below 1.
fn refracted(d: vec3f, n: vec3f, eta: f32) -> vec3f {
    let cos_i = -dot(d, n);
    let cos_t = sqrt(max(1.0 - (1.0 - cos_i * cos_i) / (eta * eta), 0.0));
    return normalize(d / eta + (cos_i / eta - cos_t) * n);
}

// A mirrored direction, about the triangle's normal where that about n would go through the triangle.
fn mirrored_about(d: vec3f, n: vec3f, ng: vec3f) -> vec3f {
    let out = reflect(d, n);
    return select(reflect(d, ng), out, dot(out, ng) > 0.0);
}

fn is_solid(hit: RnaHit) -> bool {
    if (hit.instance & IS_LIGHT) != 0u { // as RNA_NOTHING has it
        return false;
    }
    let record = rna_primitives[hit.primitive];
    return !rna_is_segment(record) && surface_has(rna_surface(record), IS_SOLID);
}

fn glass_vertex(hit: RnaHit, ray: RnaRay) -> Vertex {
    let record = rna_primitives[hit.primitive];
    var v = triangle_vertex(record, hit.b1, hit.b2);
    v.surface = rna_surface(record);
    v.instance = hit.instance;
    place_vertex(&v, record, ray, hit.t);
    v.n_world = rna_world_direction(v.n, hit.instance);
    if dot(v.n_world, v.ng_world) <= 0.0 {
        v.n_world = v.ng_world;
    }
    return v;
}

// Takes a ray that met glass on from there. inside: absorption where it is. u: in [0, 1).
fn pass_interface(f: ptr<function, Followed>, inside: ptr<function, vec3f>, u: f32) {
    let v = glass_vertex((*f).hit, (*f).ray);
    let d = (*f).ray.direction;
    let enters = dot(d, v.ng_world) < 0.0;
    let absorption = surface_absorption(v.surface) / rna_instances[v.instance].scale;
    // A ray that began inside leaves what it was not known to be in.
    let begins_inside = !enters && all(*inside == vec3f(0.0));
    let medium = select(*inside, absorption, begins_inside);
    (*f).weight *= exp(-medium * (*f).hit.t);
    let side = select(-1.0, 1.0, enters);
    let ng = side * v.ng_world;
    let n = select(side * v.n_world, ng, dot(d, side * v.n_world) > -1e-4);
    let ior = surface_ior(v.surface).x;
    let eta = select(1.0 / ior, ior, enters);
    var out = mirrored_about(d, n, ng);
    *inside = medium;
    if u >= fresnel(clamp(-dot(d, n), 0.0, 1.0), eta) {
        out = refracted(d, n, eta);
        (*f).weight *= surface_base_color(v.surface);
        *inside = max(medium + side * absorption, vec3f(0.0));
    }
    (*f).ray = RnaRay(origin_of(v, out), 0.0, out, RNA_FAR);
}

// A ray to the first hit of no glass. depth: of the point where it starts, 0 for the camera.
fn follow(start: RnaRay, ignored: u32, depth: u32, pixel: u32) -> Followed {
    let key = chance_of(pixel);
    let through = closest_through(start, ignored, frame.rays, key);
    var f = Followed(through.hit, through.hit.t, through.weight, false, start);
    var inside = vec3f(0.0);
    for (var k = 0u; is_solid(f.hit); k++) {
        f.bent = true;
        if k == MOST_INTERFACES {
            f.hit = rna_miss(RNA_FAR);
            f.weight = vec3f(0.0);
            break;
        }
        let dimension = INTERFACES + depth * MOST_INTERFACES + k;
        pass_interface(&f, &inside, square(pixel, dimension, path_of_pixel()).x);
        let behind = closest_through(f.ray, RNA_NOTHING, INDIRECT_RAY, key);
        f.hit = behind.hit;
        f.weight *= behind.weight;
    }
    if f.bent && f.hit.instance != RNA_NOTHING {
        f.weight *= exp(-inside * f.hit.t);
    }
    return f;
}
`,"render/surface_lobes.wgsl":`// The mixture of rays that leave an asset, by its surface.

fn surface_lobes(surface: u32) -> Lobes {
    let is_fiber = surface_kind(surface) == OF_FIBERS;
    return Lobes(is_fiber, surface_lobe_shares(surface), surface_lobe_widths(surface));
}
`,"render/surfaces.wgsl":`// Surfaces of the scene, by the number that primitives have; scene_surfaces.py fills them.

@group(2) @binding(4) var<storage, read> normals: array<vec4f>; // and v of meshes

fn surface_has(surface: u32, flag: u32) -> bool {
    return (surface_flags(surface) & flag) != 0u;
}

// Texture coordinates of a point, of the first or the second set.
fn corner_uv(surface: u32, point: u32, uv_set: u32) -> vec2f {
    if uv_set == 0u {
        return vec2f(rna_points[point].w, normals[point].w);
    }
    let at = surface_second_uvs(surface) + 2u * point;
    return vec2f(bitcast<f32>(images[at]), bitcast<f32>(images[at + 1u]));
}

fn corner_uvs(record: RnaPrimitive, uv_set: u32) -> mat3x2f {
    let surface = rna_surface(record);
    return mat3x2f(
        corner_uv(surface, record.a, uv_set),
        corner_uv(surface, record.b, uv_set),
        corner_uv(surface, record.c, uv_set),
    );
}

fn point_color(base: u32, point: u32) -> vec3f {
    let at = base + 3u * point;
    return bitcast<vec3f>(vec3<u32>(images[at], images[at + 1u], images[at + 2u]));
}

// The colour of the vertices, interpolated; 1 without.
fn vertex_color(surface: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let base = surface_colors(surface);
    if base == NONE {
        return vec3f(1.0);
    }
    let corners = mat3x3f(point_color(base, record.a), point_color(base, record.b), point_color(base, record.c));
    return corners * weights_of(b1, b2);
}

fn weights_of(b1: f32, b2: f32) -> vec3f {
    return vec3f(1.0 - b1 - b2, b1, b2);
}
`,"render/table_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const OF_MATERIAL: u32 = 0u;
const OF_NEURAL: u32 = 1u;
const OF_FIBERS: u32 = 2u;
const EMITS: u32 = 1u;
const FRONT_ALONE: u32 = 64u;
const BACK_ALONE: u32 = 128u;
const LETS_THROUGH: u32 = 2u;
const IS_GLASS: u32 = 4u;
const HAS_CUTOFF: u32 = 8u;
const HAS_SCHLICK: u32 = 16u;
const IS_SOLID: u32 = 32u;
const BASE: u32 = 0u;
const METAL: u32 = 1u;
const COAT: u32 = 2u;
const GLOW: u32 = 3u;
const CLEAR: u32 = 4u;
const CLEAR_ROUGH: u32 = 5u;
const THROUGH: u32 = 6u;
const RELIEF: u32 = 7u;
const LIGHT_SEEN: u32 = 1u;
const LIGHT_DELTA: u32 = 2u;
const LIGHT_INFINITE: u32 = 4u;
const DIRECTIONAL: u32 = 0u;
const DISK: u32 = 1u;
const IMAGE: u32 = 2u;
const POINT: u32 = 3u;
const RECTANGLE: u32 = 4u;
const SPHERE: u32 = 5u;
const SPOT: u32 = 6u;
const SUN: u32 = 7u;
const TRIANGLES: u32 = 8u;
const UNIFORM: u32 = 9u;

fn object_number(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].x;
}
fn object_catches(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].y);
}
fn object_passes(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].z);
}
fn object_free(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].w);
}

fn surface_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 0u].x);
}
fn surface_part(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 0u].y);
}
fn surface_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 0u].z);
}
fn surface_normal_map(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 0u].w);
}
fn surface_base_color(k: u32) -> vec3f {
    return table[frame.surfaces + 12u * k + 1u].xyz;
}
fn surface_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 1u].w;
}
fn surface_metallic(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 2u].x;
}
fn surface_coat_f0(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 2u].y;
}
fn surface_coat_weight(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 2u].z;
}
fn surface_transmission(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 2u].w;
}
fn surface_emission(k: u32) -> vec3f {
    return table[frame.surfaces + 12u * k + 3u].xyz;
}
fn surface_normal_scale(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 3u].w;
}
fn surface_clear_coat(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 4u].x;
}
fn surface_clear_coat_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 4u].y;
}
fn surface_second_uvs(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 4u].z);
}
fn surface_tangents(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 4u].w);
}
fn surface_colors(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 5u].x);
}
fn surface_textures(k: u32, i: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 6u + i / 4u][i % 4u]);
}
fn surface_through(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 12u * k + 8u].x);
}
fn surface_cutoff(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 8u].y;
}
fn surface_ior(k: u32) -> vec2f {
    return table[frame.surfaces + 12u * k + 8u].zw;
}
fn surface_absorption(k: u32) -> vec3f {
    return table[frame.surfaces + 12u * k + 9u].xyz;
}
fn surface_f0(k: u32) -> f32 {
    return table[frame.surfaces + 12u * k + 9u].w;
}
fn surface_lobe_shares(k: u32) -> vec4f {
    return table[frame.surfaces + 12u * k + 10u].xyzw;
}
fn surface_lobe_widths(k: u32) -> vec4f {
    return table[frame.surfaces + 12u * k + 11u].xyzw;
}

fn texture_place(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].x);
}
fn texture_size(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].y);
}
fn texture_form(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].z);
}
fn texture_row_u(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 1u].xyz;
}
fn texture_row_v(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 2u].xyz;
}

fn light_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].x);
}
fn light_group(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].y);
}
fn light_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].z);
}
fn light_instance(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].w);
}
fn light_numbers(k: u32, i: u32) -> f32 {
    return table[frame.lights + 8u * k + 1u + i / 4u][i % 4u];
}
fn light_probability(k: u32) -> vec3f {
    return table[frame.lights + 8u * k + 6u].xyz;
}
fn light_places(k: u32) -> vec4<u32> {
    return bitcast<vec4<u32>>(table[frame.lights + 8u * k + 7u].xyzw);
}

fn light_colour(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 0u), light_numbers(k, 1u), light_numbers(k, 2u));
}
fn directional_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn disk_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn disk_radius(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn image_turn_cosine(k: u32) -> f32 {
    return light_numbers(k, 3u);
}
fn image_turn_sine(k: u32) -> f32 {
    return light_numbers(k, 4u);
}
fn image_total(k: u32) -> f32 {
    return light_numbers(k, 5u);
}
fn image_mean(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn image_rows(k: u32) -> f32 {
    return light_numbers(k, 7u);
}
fn image_columns(k: u32) -> f32 {
    return light_numbers(k, 8u);
}
fn point_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn rectangle_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn rectangle_half(k: u32) -> vec2f {
    return vec2f(light_numbers(k, 15u), light_numbers(k, 16u));
}
fn sphere_centre(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sphere_radius(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn spot_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn spot_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 6u), light_numbers(k, 7u), light_numbers(k, 8u));
}
fn spot_cos_inner(k: u32) -> f32 {
    return light_numbers(k, 9u);
}
fn spot_cos_outer(k: u32) -> f32 {
    return light_numbers(k, 10u);
}
fn sun_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sun_one_minus_cosine(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn triangles_rotation(k: u32) -> mat3x3f {
    return mat3x3f(light_numbers(k, 3u), light_numbers(k, 6u), light_numbers(k, 9u), light_numbers(k, 4u), light_numbers(k, 7u), light_numbers(k, 10u), light_numbers(k, 5u), light_numbers(k, 8u), light_numbers(k, 11u));
}
fn triangles_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 12u), light_numbers(k, 13u), light_numbers(k, 14u));
}
fn triangles_scale(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn image_texels(k: u32) -> u32 {
    return light_places(k).x;
}
fn image_heights(k: u32) -> u32 {
    return light_places(k).y;
}
fn image_row_sums(k: u32) -> u32 {
    return light_places(k).z;
}
fn image_column_sums(k: u32) -> u32 {
    return light_places(k).w;
}
fn triangles_sums(k: u32) -> u32 {
    return light_places(k).x;
}
fn triangles_primitives(k: u32) -> u32 {
    return light_places(k).y;
}
fn triangles_densities(k: u32) -> u32 {
    return light_places(k).z;
}
fn triangles_count(k: u32) -> u32 {
    return light_places(k).w;
}
`,"render/textures.wgsl":`// Textures on triangles: rna_render/materials/textures.py.

fn rna_image_word(at: u32) -> u32 {
    return images[at];
}

fn image_of(texture: u32) -> RnaImage {
    let size = texture_size(texture);
    return RnaImage(texture_place(texture), vec2<u32>(size & 0xffffu, size >> 16u), texture_form(texture));
}

// From coordinates of the mesh to the image's.
fn image_place(texture: u32, uv: vec2f) -> vec2f {
    let at = vec3f(uv, 1.0);
    return vec2f(dot(texture_row_u(texture), at), dot(texture_row_v(texture), at));
}

// At the mesh's coordinates.
fn texture_value(texture: u32, uv: vec2f) -> vec3f {
    return rna_image_color(image_of(texture), image_place(texture, uv));
}

// On a triangle at barycentrics.
fn texture_on(texture: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let uv_set = (image_of(texture).form >> 5u) & 1u;
    return texture_value(texture, corner_uvs(record, uv_set) * weights_of(b1, b2));
}

// A texture of the triangle's material; 1 where it has none.
fn factor_on(k: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let texture = surface_textures(rna_surface(record), k);
    if texture == NONE {
        return vec3f(1.0);
    }
    return texture_on(texture, record, b1, b2);
}

// Radiance that a material emits, to both sides.
fn emission_on(record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    return surface_emission(rna_surface(record)) * factor_on(GLOW, record, b1, b2);
}
`,"render/tracing.wgsl":`// Rays of the three sorts through the whole scene. light_shapes.wgsl adds lights with a shape, or a host says
//     fn with_lights(ray: RnaRay, rays: u32, of_geometry: RnaHit) -> RnaHit
// where there are none.

struct Through {
    hit: RnaHit,
    weight: vec3f, // for what the ray passed or hit at random, if that has a colour
}

// The closest hit of a camera or indirect ray, whose bit is \`rays\`; \`key\` decides what it passes.
fn closest_through(ray: RnaRay, ignored: u32, rays: u32, key: u32) -> Through {
    var hit = rna_miss(ray.far);
    var line = ray;
    var share = vec3f(1.0);
    chance_key = key;
    stopped_share = vec3f(1.0);
    start_passing(AT_RANDOM);
    loop {
        let of_geometry = rna_trace(line, ignored, rays, false);
        if passing == WEIGH {
            break;
        }
        hit = with_lights(ray, rays, of_geometry);
        let is_triangle = (hit.instance & IS_LIGHT) == 0u
            && !rna_is_segment(rna_primitives[hit.primitive]);
        share = select(share, stopped_share, is_triangle);
        if !is_coloured {
            break;
        }
        passing = WEIGH;
        line.far = hit.t;
    }
    return Through(hit, share * passed_weight);
}

// What a shadow ray keeps of its light.
fn visible_on(ray: RnaRay, ignored: u32) -> vec3f {
    start_passing(WEAKEN);
    var hit = rna_trace(ray, ignored, frame.rays, true);
    if hit.instance == RNA_NOTHING {
        hit = with_lights(ray, frame.rays, hit);
    }
    return select(vec3f(0.0), passed_weight, hit.instance == RNA_NOTHING);
}

// What an asset leaves of light along a ray from itself, in its object space.
fn start_visibility(instance: u32, ray: RnaRay, strand: u32) -> vec3f {
    var hit = rna_miss(ray.far);
    let root = rna_instances[instance].root;
    start_passing(WEAKEN);
    let stopped = rna_trace_body(root, ray, strand, true, &hit);
    return select(passed_weight, vec3f(0.0), stopped);
}
`,"render/transmittance.wgsl":`// What triangles let through, of materials and of assets: spec/RNA.md, 4.4 Transmittance, and
// rna_trace/transmittance.py.

// Unpolarised, of an interface of relative index eta.
fn dielectric_reflectance(eta: f32, cosine: f32) -> f32 {
    let squared = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    if squared <= 0.0 {
        return 1.0;
    }
    let root = sqrt(squared);
    let s = (cosine - eta * root) / (cosine + eta * root);
    let p = (eta * cosine - root) / (eta * cosine + root);
    return 0.5 * (s * s + p * p);
}

// The part that a smooth interface does not reflect of a ray along d, in object space.
fn passed_interface(
    record: RnaPrimitive, b: vec3f, d: vec3f, facing: bool,
) -> f32 {
    let surface = rna_surface(record);
    let ior = surface_ior(surface);
    let eta = select(ior.y, ior.x, facing);
    let schlick = surface_has(surface, HAS_SCHLICK);
    if eta == 0.0 && !schlick {
        return 1.0;
    }
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz) * b;
    let cosine = min(abs(dot(n, d)) / max(sqrt(dot(n, n) * dot(d, d)), 1e-30), 1.0);
    if eta != 0.0 {
        return 1.0 - dielectric_reflectance(eta, cosine);
    }
    let f0 = surface_f0(surface);
    let away = 1.0 - cosine;
    return (1.0 - f0) * (1.0 - away * away * away * away * away);
}

// Of a triangle, for a ray along d in object space. facing: it meets the normal's side.
fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    let surface = rna_surface(record);
    if !surface_has(surface, LETS_THROUGH) {
        return vec3f(0.0);
    }
    var tau = texture_on(surface_through(surface), record, b1, b2);
    if surface_has(surface, HAS_CUTOFF) {
        tau = select(vec3f(0.0), vec3f(1.0), tau > vec3f(surface_cutoff(surface)));
    }
    let passed = passed_interface(record, weights_of(b1, b2), d, facing);
    return min(tau * passed, vec3f(1.0));
}
`,"render/triangle_lights.wgsl":`// Triangles that shine, of an object or an asset: rna_render/lights/kinds/mesh.py. In \`images\` a light has
// running sums of its triangles' shares (count + 1), their primitives (count), and densities per area
// by primitive of the body.

// Of points on either side of a triangle, seen from x along d, in object space.
fn triangle_pdf(light: u32, primitive: u32, x: vec3f, d: vec3f) -> f32 {
    let per_area = bitcast<f32>(images[triangles_densities(light) + primitive]);
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let area = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let normal = area / max(length(area), 1e-30);
    let side = select(1.0, -1.0, dot(x - p, normal) < 0.0);
    return flat_pdf(p, side * normal, per_area, x, d);
}

// Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting
// Calculations (TOG 15(1), 1996), section 3.2.
fn sample_triangles(light: u32, x_world: vec3f, u: vec2f) -> LightSample {
    let sums_at = triangles_sums(light);
    let count = triangles_count(light);
    if count == 0u {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let instance = light_instance(light);
    let x = rna_object_point(x_world, instance);
    let value = u.x * image_float(sums_at + count);
    let chosen = interval(sums_at, count, value);
    let root = sqrt(place_within(sums_at, chosen, value));
    let b = vec2f(root * (1.0 - u.y), root * u.y);
    let primitive = images[triangles_primitives(light) + chosen];
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let way = p - x + b.x * (rna_points[record.b].xyz - p) + b.y * (rna_points[record.c].xyz - p);
    let r = length(way);
    let wi = way / max(r, 1e-30);
    let pdf = select(0.0, triangle_pdf(light, primitive, x, wi), r > 0.0);
    let scale = rna_instances[instance].scale;
    let wi_world = rna_world_direction(wi, instance);
    let colour = light_colour(light);
    return LightSample(wi_world, r * scale, colour, pdf, primitive, b.x, b.y);
}
`,"render/vertex.wgsl":`// The point that a path has come to, from its hit.

// Of a rounding error, 2^-24, the times that it may come in: rna_trace/hit_points.py has half of it, in float64.
const ROUNDING: f32 = 32.0 * 0x1p-24f;
const LEAST_STEP: f32 = 0x1p-24f; // as there

struct Vertex {
    x: vec3f, // object space, as all that is not said otherwise
    kind: u32,
    n: vec3f, // interpolated normal, or that of a segment
    surface: u32,
    ng: vec3f,
    part: u32,
    lift: vec3f,
    h: f32,
    axis: vec3f, // of a decoder's queries: mapped normal or tangent
    strand: u32,
    wo: vec3f,
    instance: u32,
    x_world: vec3f,
    shading: vec3f, // mapped normal of meshes, n of strands
    n_world: vec3f, // the same
    b1: f32,
    ng_world: vec3f,
    b2: f32,
    record: RnaPrimitive, // of its primitive
    step: f32, // of materials: how far along ng_world rays from here start
}

// Of a normal map: a u32 a texel, whose first two bytes are its numbers.
fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f {
    let at = image_of(map);
    let word = images[at.place + row * at.size.x + column];
    return vec2f(f32(word & 255u), f32((word >> 8u) & 255u));
}

fn triangle_vertex(record: RnaPrimitive, b1: f32, b2: f32) -> Vertex {
    var v: Vertex;
    let b = weights_of(b1, b2);
    let p = mat3x3f(
        rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
    );
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz);
    v.x = p[0] + b1 * (p[1] - p[0]) + b2 * (p[2] - p[0]);
    let mixed = n * b;
    v.n = select(vec3f(0.0), mixed / max(length(mixed), 1e-30), dot(mixed, mixed) > 0.0);
    let area = cross(p[1] - p[0], p[2] - p[0]);
    let largest = max(abs(area.x), max(abs(area.y), abs(area.z)));
    if largest > 0.0 {
        v.ng = normalize(area / largest);
    }
    v.lift = rna_lift(v.x, b, p, n);
    v.shading = v.n;
    v.b1 = b1;
    v.b2 = b2;
    let map = surface_normal_map(rna_surface(record));
    if map != NONE {
        v.shading = rna_mapped_normal(map, image_of(map).size, v.n, p, corner_uvs(record, 0u), b);
    }
    v.axis = v.shading;
    v.strand = RNA_NOTHING;
    return v;
}

// u and n as of the hit: the point of an RnaEntry, without the error of its ray's length.
fn segment_vertex(record: RnaPrimitive, u: f32, n: vec3f, wo: vec3f) -> Vertex {
    var v: Vertex;
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    let size = max(abs(way.x), max(abs(way.y), abs(way.z)));
    v.axis = normalize(way / size);
    v.n = n;
    v.ng = n;
    v.x = mix(cone.a, cone.b, u) + mix(cone.ra, cone.rb, u) * n;
    let across = cross(v.axis, wo);
    let width = length(across);
    if width > 1e-6 {
        v.h = clamp(dot(v.n, across) / width, -1.0, 1.0);
    }
    v.shading = v.n;
    v.strand = rna_strand(record);
    return v;
}

// Of a triangle's point: its place in the world, and the step of rays from there, both as right where the triangle is
// wide as where it is small: rna_trace/hit_points.py. The ray has hit it at t, world units.
fn place_vertex(v: ptr<function, Vertex>, record: RnaPrimitive, ray: RnaRay, t: f32) {
    let instance = (*v).instance;
    let p = rna_points[record.a].xyz;
    let e1 = rna_points[record.b].xyz - p;
    let e2 = rna_points[record.c].xyz - p;
    let size = rna_box_size(e1, e2);
    let far = t / rna_instances[instance].scale;
    let longest = max(size.x, max(size.y, size.z));
    if longest > far {
        let x = rna_object_point(ray.origin, instance) + far * rna_object_direction(ray.direction, instance);
        (*v).x = x - dot(x - p, (*v).ng) * (*v).ng;
    }
    (*v).x_world = rna_world_point((*v).x, instance);
    (*v).ng_world = rna_world_direction((*v).ng, instance);
    let reach = abs((*v).x_world) + abs(rna_instances[instance].place);
    let rounded = reach.x * abs(rna_instances[instance].rotation[0].xyz)
        + reach.y * abs(rna_instances[instance].rotation[1].xyz)
        + reach.z * abs(rna_instances[instance].rotation[2].xyz);
    // The volume of the box over twice the area; the latter by the largest component, whose square stays in float32.
    let n = cross(e1, e2);
    let largest = max(abs(n.x), max(abs(n.y), abs(n.z)));
    let uncertain = LEAST_STEP * longest + select(0.0, size.x / largest * size.y * size.z, largest > 0.0);
    let along = abs((*v).ng) + LEAST_STEP;
    (*v).step = ROUNDING * (dot(along, rounded) + rna_instances[instance].scale * uncertain);
}

fn vertex_of(path: Path) -> Vertex {
    let record = rna_primitives[path.primitive];
    let wo = rna_object_direction(-path.direction, path.instance);
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, path.b1, path.b2);
    } else {
        v = segment_vertex(record, path.b1, path.normal, wo);
    }
    v.record = record;
    v.surface = rna_surface(record);
    v.kind = surface_kind(v.surface);
    v.part = surface_part(v.surface);
    if v.kind == OF_MATERIAL {
        v.shading = bumped_normal(record, v.b1, v.b2, v.n, v.ng, wo);
    }
    v.wo = wo;
    v.instance = path.instance;
    if v.kind == OF_MATERIAL {
        place_vertex(&v, record, RnaRay(path.origin, 0.0, path.direction, RNA_FAR), path.t);
    } else {
        v.x_world = rna_world_point(v.x, path.instance);
        v.ng_world = rna_world_direction(v.ng, path.instance);
    }
    v.n_world = rna_world_direction(v.shading, path.instance);
    return v;
}

// Of the asset's point where a path is.
fn base_color_of(path: Path, v: Vertex) -> vec3f {
    if v.kind == OF_FIBERS {
        return vec3f(1.0);
    }
    let width = frame.spread * path.t / rna_instances[v.instance].scale;
    return base_color_on(v.record, v.b1, v.b2, width);
}

// Where rays along wi start in the world: on materials a step off the surface.
fn origin_of(v: Vertex, wi_world: vec3f) -> vec3f {
    return v.x_world + select(v.step, -v.step, dot(v.ng_world, wi_world) < 0.0) * v.ng_world;
}

// Origin of the visibility ray along wi against the asset itself; object space.
fn leaving_point(v: Vertex, wi: vec3f) -> vec3f {
    if v.kind == OF_FIBERS {
        return v.x;
    }
    let extent = rna_instances[v.instance].extent;
    return rna_leaving_origin(v.x, v.n, v.ng, v.lift, wi, extent);
}

fn instance_scale(instance: u32) -> f32 {
    return rna_instances[instance].scale;
}

// Whether a scattered ray has come to the point from inside a solid. Captures see assets from outside; inside they are
// black.
fn is_inside(v: Vertex) -> bool {
    let never = select(FRONT_ALONE, BACK_ALONE, dot(v.ng, v.wo) > 0.0);
    return frame.depth > 1u && surface_has(v.surface, never);
}
`,"row_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

struct RnaRow { // 80 bytes
    position: vec3<u32>, // 0; object space
    h: u32, // 12
    axis: vec3<u32>, // 16; normal or tangent
    red: u32, // 28; of the base colour
    wo: vec3<u32>, // 32
    green: u32, // 44
    wi: vec3<u32>, // 48
    blue: u32, // 60
    nearby: vec3<u32>, // 64; nearby light
    has_nearby: u32, // 76; 0: the part's means stand in
}
`,"segment.wgsl":`// Where a ray enters a round cone from outside: spec/RNA.md, 4.2 Curves and 7.1 Transport.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

fn rna_cone(point: u32) -> RnaCone {
    let a = rna_points[point];
    let b = rna_points[point + 1u];
    return RnaCone(a.xyz, a.w, b.xyz, b.w);
}

// Along d from p to where it enters the sphere; RNA_FAR where it does not.
fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    let v = p - centre;
    let along = dot(v, d);
    let rest = v - along * d;
    let h = radius * radius - dot(rest, rest);
    if h <= 0.0 {
        return RNA_FAR;
    }
    return -along - sqrt(h);
}

// How far p is outside of the cone; negative inside.
fn rna_cone_distance(cone: RnaCone, p: vec3f) -> f32 {
    let axis = cone.b - cone.a;
    let size = length(axis);
    let dr = cone.ra - cone.rb;
    let v = p - cone.a;
    let y = dot(v, axis) / size;
    let x = length(v - axis * (y / size));
    let to_a = length(vec2f(x, y)) - cone.ra;
    let to_b = length(vec2f(x, y - size)) - cone.rb;
    if size <= abs(dr) {
        return select(to_b, to_a, dr > 0.0);
    }
    let slope = dr / size;
    let lean = sqrt(1.0 - slope * slope);
    let along = y * lean - x * slope;
    if along <= 0.0 {
        return to_a;
    }
    if along >= size * lean {
        return to_b;
    }
    return x * lean + y * slope - cone.ra;
}

struct RnaEntry {
    t: f32,
    u: f32, // of the sphere that touches the surface there: how far along the segment its middle is, 0 to 1
    normal: vec3f,
}

// The entry of the line into the cone: of the points where it enters a sphere at an end, or the side
// between them, the first. \`from\` is near the cone, to keep digits.
fn rna_enter_cone(cone: RnaCone, p: vec3f, d: vec3f) -> RnaEntry {
    let ta = rna_enter_sphere(p, d, cone.a, cone.ra);
    let tb = rna_enter_sphere(p, d, cone.b, cone.rb);
    var entry = RnaEntry(min(ta, tb), select(1.0, 0.0, ta < tb), vec3f(0.0));
    entry.normal = p + entry.t * d - select(cone.b, cone.a, ta < tb);
    let axis = cone.b - cone.a;
    let v = p - cone.a;
    let dr = cone.ra - cone.rb;
    let squared = dot(axis, axis);
    let d2 = squared - dr * dr;
    let m1 = dot(axis, v);
    let m2 = dot(axis, d);
    let k2 = d2 - m2 * m2;
    let k1 = d2 * dot(d, v) - m1 * m2 + m2 * dr * cone.ra;
    let k0 = d2 * dot(v, v) - m1 * m1 + 2.0 * m1 * dr * cone.ra - squared * cone.ra * cone.ra;
    let h = k1 * k1 - k0 * k2;
    if d2 <= 0.0 || h < 0.0 || k2 == 0.0 {
        return entry;
    }
    for (var sign = -1.0; sign <= 1.0; sign += 2.0) {
        let side = (sign * sqrt(h) - k1) / k2;
        let y = m1 - cone.ra * dr + side * m2;
        let normal = d2 * (v + side * d) - axis * y;
        if y > 0.0 && y < d2 && side < entry.t && dot(normal, d) < 0.0 {
            entry = RnaEntry(side, y / d2, normal);
        }
    }
    return entry;
}

// Whether p, on a segment, is inside the one before or after it: there is no surface there.
fn rna_in_neighbour(segment: RnaPrimitive, p: vec3f) -> bool {
    if (segment.b & RNA_HAS_BEFORE) != 0u {
        let before = rna_cone(segment.a - 1u);
        if rna_cone_distance(before, p) < -1e-4 * min(before.ra, before.rb) {
            return true;
        }
    }
    if (segment.b & RNA_HAS_AFTER) != 0u {
        let after = rna_cone(segment.a + 1u);
        return rna_cone_distance(after, p) < -1e-4 * min(after.ra, after.rb);
    }
    return false;
}

// t of RNA_FAR for a miss.
fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    let miss = RnaEntry(RNA_FAR, 0.0, vec3f(0.0));
    let cone = rna_cone(segment.a);
    let shift = dot(0.5 * (cone.a + cone.b) - ray.origin, ray.direction);
    let p = ray.origin + shift * ray.direction;
    let entry = rna_enter_cone(cone, p, ray.direction);
    let t = entry.t + shift;
    if entry.t >= RNA_FAR || !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    if rna_in_neighbour(segment, p + entry.t * ray.direction) {
        return miss;
    }
    return RnaEntry(t, entry.u, normalize(entry.normal));
}
`,"surface.wgsl":`// Transport, or emission, at a point of a surface: spec/RNA.md, 7 Light.

// x: object space, metres. n, wo, wi: unit, away from the surface; all finite. An emission decoder
// reads no wi, and one without factors no base colour. nearby: nearby light, and 1; with a 0 behind it the part's means
// stand in.
fn rna_surface(
    x: vec3f, n: vec3f, wo: vec3f, wi: vec3f, base_color: vec3f, nearby: vec4f,
) -> RnaTransport {
    rna_put_queries(x, n, 0.0, wo, wi, rna_halfway(wo, wi));
    return rna_decode(base_color, nearby);
}

// m: the half vector.
fn rna_put_queries(x: vec3f, n: vec3f, h: f32, wo: vec3f, wi: vec3f, m: vec3f) {
    let p = rna_relative(x);
    rna_surface_blocks(p, n, rna_put_features(p), wo, wi, m);
}

fn rna_query(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f, base_color: vec3f, nearby: vec4f,
) -> RnaTransport {
    return rna_surface(x, axis, wo, wi, base_color, nearby);
}
`,"surface_blocks.wgsl":`// Input blocks of a surface, but \`features\`. Generated by \`python -m rna_sdk.package.write_blocks\`; do not edit. Formulas: RNA.md, 6.3.

fn rna_halfway(wo: vec3f, wi: vec3f) -> vec3f {
    let total = wi + wo;
    let apart = wi - wo;
    let square = dot(apart, apart);
    let share = select(0.0, dot(total, apart) / max(square, 1.0), dot(total, total) < square);
    let middle = total - apart * share;
    let size = dot(middle, middle);
    let scale = select(1.0 / sqrt(max(size, 1e-12)), 0.0, size < 1e-12);
    let m = middle * scale;
    return m;
}

fn rna_surface_blocks(p: vec3f, n: vec3f, f: vec3f, wo: vec3f, wi: vec3f, m: vec3f) {
    if rna_slot(RNA_BLOCK_POSITION) != RNA_NONE {
        rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    }
    rna_put(rna_slot(RNA_BLOCK_NORMAL), vec4f(n, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    if rna_slot(RNA_BLOCK_HALF_VECTOR) != RNA_NONE || rna_slot(RNA_BLOCK_HIGHLIGHT) != RNA_NONE || rna_slot(RNA_BLOCK_LEARNED_NORMAL) != RNA_NONE {
        let across = dot(m, m) == 0.0;
        if rna_slot(RNA_BLOCK_HALF_VECTOR) != RNA_NONE {
            let off_n = n - m;
            let n_gap = select(dot(off_n, off_n) / 2.0, 1.0, across);
            rna_put(rna_slot(RNA_BLOCK_HALF_VECTOR), vec4f(dot(n, m), log2(n_gap + 0.0001) / 6.0, dot(n, wi), dot(n, wo)));
            rna_put(rna_slot(RNA_BLOCK_HALF_VECTOR) + 1u, vec4f(dot(wi, m), 0.0, 0.0, 0.0));
        }
        if rna_slot(RNA_BLOCK_HIGHLIGHT) != RNA_NONE {
            let aside = cross(n, m);
            rna_put(rna_slot(RNA_BLOCK_HIGHLIGHT), vec4f(log2(select(dot(aside, aside), 1.0, across) + 1e-08) / 12.0, 0.0, 0.0, 0.0));
        }
        if rna_slot(RNA_BLOCK_LEARNED_NORMAL) != RNA_NONE {
            let bent = n + 0.1 * f;
            let nothing = dot(bent, bent) < 1e-12;
            let top = max(rna_largest(bent), 1e-06);
            let part = bent / top;
            let norm = sqrt(max(dot(part, part), 0.5));
            let q = select(part / norm, n, nothing);
            let off_q = q - m;
            let q_gap = select(dot(off_q, off_q) / 2.0, 1.0, across);
            rna_put(rna_slot(RNA_BLOCK_LEARNED_NORMAL), vec4f(dot(q, m), log2(q_gap + 0.0001) / 6.0, 0.0, 0.0));
        }
    }
}
`,"triangle.wgsl":`// Where a ray meets a triangle, from either side, watertight: Woop, Benthin and Wald, Watertight
// Ray/Triangle Intersection (JCGT 2(1), 2013).

// Coordinates with the ray's largest one last.
fn rna_turned(v: vec3f, axis: u32) -> vec3f {
    if axis == 0u {
        return v.yzx;
    }
    if axis == 1u {
        return v.zxy;
    }
    return v;
}

fn rna_largest_axis(d: vec3f) -> u32 {
    let size = abs(d);
    if size.x > size.y && size.x > size.z {
        return 0u;
    }
    return select(2u, 1u, size.y > size.z);
}

// t by the triangle's plane, or \`t\` where that is nearer to the truth: a plane across an axis is exact however wide
// it is, and the other loses 2^-24 of the corners' distance; of slivers the plane is uncertain.
fn rna_distance(ray: RnaRay, way: vec3f, e1: vec3f, e2: vec3f, t: f32, depth: f32) -> f32 {
    let n = cross(e1, e2);
    let size = rna_box_size(e1, e2);
    let uncertain = dot(abs(way), size.yzx * size.zxy);
    let along = dot(n, ray.direction);
    let is_better = along != 0.0 && uncertain < depth * max(abs(n.x), max(abs(n.y), abs(n.z)));
    return select(t, dot(n, way) / along, is_better);
}

// (t, b1, b2), t of RNA_FAR for a miss.
fn rna_meet_triangle(ray: RnaRay, p0: vec3f, p1: vec3f, p2: vec3f) -> vec3f {
    let miss = vec3f(RNA_FAR, 0.0, 0.0);
    let axis = rna_largest_axis(ray.direction);
    let d = rna_turned(ray.direction, axis);
    let shear = vec3f(d.x / d.z, d.y / d.z, 1.0 / d.z);
    let a = rna_turned(p0 - ray.origin, axis);
    let b = rna_turned(p1 - ray.origin, axis);
    let c = rna_turned(p2 - ray.origin, axis);
    let a2 = a.xy - shear.xy * a.z;
    let b2 = b.xy - shear.xy * b.z;
    let c2 = c.xy - shear.xy * c.z;
    let u = c2.x * b2.y - c2.y * b2.x;
    let v = a2.x * c2.y - a2.y * c2.x;
    let w = b2.x * a2.y - b2.y * a2.x;
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return miss;
    }
    let sum = u + v + w;
    if sum == 0.0 {
        return miss;
    }
    let depth = max(abs(a.z), max(abs(b.z), abs(c.z)));
    let mixed = (u * a.z + v * b.z + w * c.z) * shear.z / sum;
    let t = rna_distance(ray, p0 - ray.origin, p1 - p0, p2 - p0, mixed, depth);
    if !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    return vec3f(t, v / sum, w / sum);
}
`,"visibility.wgsl":`// Where visibility rays of meshes start: spec/RNA.md, 7.1 Transport. Those of strands start at x.

// From x, at barycentric coordinates b of a triangle, onto the smooth surface it stands for.
fn rna_lift(x: vec3f, b: vec3f, p: mat3x3f, n: mat3x3f) -> vec3f {
    return b.x * max(0.0, dot(p[0] - x, n[0])) * n[0]
        + b.y * max(0.0, dot(p[1] - x, n[1])) * n[1]
        + b.z * max(0.0, dot(p[2] - x, n[2])) * n[2];
}

// n: interpolated, ng: of the triangle; extent: largest absolute coordinate of the asset.
fn rna_leaving_origin(
    x: vec3f, n: vec3f, ng: vec3f, lift: vec3f, wi: vec3f, extent: f32,
) -> vec3f {
    let step = extent * 0x1p-18f;
    let above_plane = dot(ng, wi);
    let is_smooth = dot(n, ng) > 0.0;
    let above = select(above_plane, dot(n, wi), is_smooth);
    if is_smooth && above > 0.0 && above_plane < 0.1 {
        return x + (1.0 - max(0.0, above_plane) / 0.1) * lift + step * ng;
    }
    return x + select(step, -step, above < 0.0) * ng;
}
`,"weights_storage.wgsl":`// Weights of more than 64 KiB.

@group(0) @binding(1) var<storage, read> rna_weights: array<vec4f>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`,"weights_uniform.wgsl":`// Weights of up to 64 KiB. On software drivers they are read ten times faster from a uniform
// buffer than from storage.

@group(0) @binding(1) var<uniform> rna_weights: array<vec4f, 4096>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`};var Et=`// A band of the picture between the kernels, and the viewer's own numbers of a step, with rna_gpu's Frame.

struct View {
    first: u32,  // pixel of the band
    jitter: f32, // 0: rays through the middles of pixels, 1: anywhere in them
    kind: u32,   // of the light: LIGHT_SUN and so on
    is_first: u32, // 1: the sum starts with this
    direction: vec3f, // of a sun
    counts_coverage: u32,
    colour: vec3f, // irradiance of a sun
    ground: f32,   // its height
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    middle: vec2f,        // of the ground, x and z
    part: u32,     // of the queries, + 1
    form: u32,     // of the answers: up to FORM_SHADOWED two vec4f each; FORM_EMISSION or FORM_ENVIRONMENT, one
    shift: vec2f,  // of the rays, pixels
    light_width: u32, // of the picture that has the first look's light, pixels
    light_height: u32,
    shares: f32,   // rays a pixel of the first look's edges
    texel: f32,    // of the lobes' planes, object space
    light_scale: vec2f, // width and height of that picture over those of the band's
    lengths: vec3f, // of the nearby light that the part counts
    number: u32,    // of the light
}

const FORM_TRANSPORT = 0u;
const FORM_VISIBLE = 1u;
const FORM_SHADOWED = 2u;
const FORM_EMISSION = 3u;
const FORM_ENVIRONMENT = 4u;

// A pixel: the members of a row of rna_evaluate, with two numbers in free ones; and its weights.
struct Pixel {
    position: vec4<u32>, // and h of a fiber; where nothing is hit, the start of the ray
    axis: vec4<u32>,     // and part + 1; or 0 where nothing is hit, with BENT_AWAY first if that is behind glass
    wo: vec4<u32>,       // and the primitive
    wi: vec4<u32>,
    through: vec3f, // throughput
    b1: f32,        // barycentric coordinates; of a segment how far along it, 0 to 1
    radiance: vec3f, // over the density, times the throughput; of the ground what it sends on
    b2: f32,
    visibility: vec3f,
    coverage: f32, // of the ground
    base_color: vec3f,
    detail: vec3f, // factor of the lobes' first half
    nearby: vec3f, // nearby light, where the part counts it
}

const BENT_AWAY = 1u;

@group(1) @binding(0) var<storage, read_write> band: array<Pixel>;
@group(1) @binding(1) var<uniform> view: View;
`;var Ml=`// Inputs of decoders of lobes: the asset's own visibility about a query's point.

@group(2) @binding(0) var<storage, read> count: array<u32>; // [0]; then the pixel of each row
@group(2) @binding(1) var<storage, read> primitives: array<RnaPrimitive>;
@group(2) @binding(2) var<storage, read> harmonics: array<vec4<u32>>; // of a point, 16 int8: of 127
@group(2) @binding(3) var<storage, read_write> columns: array<vec4f>; // 4 a row

fn harmonic(point: u32, k: u32) -> vec4f {
    return unpack4x8snorm(harmonics[point][k]);
}

@compute @workgroup_size(64)
fn write_visibility(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= count[0] {
        return;
    }
    let pixel = band[count[at + 1u]];
    let record = primitives[pixel.wo.w];
    let is_segment = (record.tag & RNA_IS_SEGMENT) != 0u;
    let second = select(record.b, record.a + 1u, is_segment);
    let third = select(record.c, record.a, is_segment);
    for (var k = 0u; k < 4u; k++) {
        let first = (1.0 - pixel.b1 - pixel.b2) * harmonic(record.a, k);
        columns[4u * at + k] = first + pixel.b1 * harmonic(second, k) + pixel.b2 * harmonic(third, k);
    }
}
`;var Ll=`// A ray from the camera through each pixel of the band, to the query of its first hit.

const LEAST_BASE_COLOR = 0.02;

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

// There are no lights with a shape.
fn with_lights(ray: RnaRay, rays: u32, of_geometry: RnaHit) -> RnaHit {
    return of_geometry;
}

fn along_segment(record: RnaPrimitive, x: vec3f) -> f32 {
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    return clamp(dot(x - cone.a, way) / max(dot(way, way), 1e-30), 0.0, 1.0);
}

fn pixel_of(hit: RnaHit, ray: RnaRay) -> Pixel {
    var pixel: Pixel;
    let wo = -ray.direction;
    pixel.wo = words(wo, hit.primitive);
    if hit.instance == RNA_NOTHING {
        pixel.position = words(ray.origin, 0u);
        return pixel;
    }
    let record = rna_primitives[hit.primitive];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, hit.b1, hit.b2);
    } else {
        v = segment_vertex(record, hit.b1, hit.normal, wo);
    }
    pixel.position = words(v.x, bitcast<u32>(v.h));
    pixel.axis = words(v.axis, surface_part(rna_surface(record)) + 1u);
    pixel.b1 = select(hit.b1, along_segment(record, v.x), rna_is_segment(record));
    pixel.b2 = hit.b2;
    pixel.base_color = vec3f(1.0);
    pixel.detail = vec3f(1.0);
    if !rna_is_segment(record) {
        let width = frame.spread * distance(frame.camera, v.x);
        var colors = mat2x3f(); // the second where there are lobes
        for (var k = 0u; k < select(1u, 2u, view.texel > 0.0); k++) {
            colors[k] = base_color_on(record, hit.b1, hit.b2, select(width, max(view.texel, width), k == 1u));
        }
        pixel.base_color = colors[0];
        // The base colour over that of a texel of the lobes' planes: spec/RNA.md, 12.1, Print.
        pixel.detail = (colors[0] + LEAST_BASE_COLOR) / (colors[1] + LEAST_BASE_COLOR);
    }
    return pixel;
}

@compute @workgroup_size(64)
fn trace_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let place = vec2f(vec2<u32>(number % frame.width, number / frame.width));
    let at = place + mix(vec2f(0.5), square(number, 0u, frame.sample), view.jitter) + view.shift;
    let d = normalize(frame.corner + at.x * frame.step_x + at.y * frame.step_y);
    let ray = RnaRay(frame.camera, 0.0, d, RNA_FAR);
    let followed = follow(ray, RNA_NOTHING, 0u, number);
    var pixel = pixel_of(followed.hit, followed.ray);
    pixel.through = followed.weight;
    if followed.bent && followed.hit.instance == RNA_NOTHING {
        pixel.axis.x = BENT_AWAY;
    }
    band[k] = pixel;
}

// The normals of hits whose primitives and barycentric coordinates are in the band.
@compute @workgroup_size(64)
fn find_normals(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let hit = RnaHit(0.0, 0u, band[k].wo.w, band[k].b1, band[k].b2, vec3f(0.0));
        let ray = RnaRay(frame.camera, 0.0, -bitcast<vec3f>(band[k].wo.xyz), RNA_FAR);
        band[k].axis = pixel_of(hit, ray).axis;
    }
}

// Likewise the base colours; the level of images is where the coverage is.
@compute @workgroup_size(64)
fn find_base_colors(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let at = band[k];
        band[k].base_color = base_color_of_level(rna_primitives[at.wo.w], at.b1, at.b2, at.coverage);
    }
}
`;var Pl=`// For each query a direction of one light, the radiance from there, and how much of it the asset lets through; and
// the light on the ground. sources.js declares the kinds of light.

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// Directions about a point: of an asset those of the rays that leave it, of the ground by the cosine.
struct Surroundings {
    at: LobeFrame,
    lobes: Lobes,
}

const GROUND_SHARE = 0.75; // of the cosine lobe; light that is low comes from all sides

fn surroundings_of(pixel: Pixel) -> Surroundings {
    let up = vec3f(0.0, 1.0, 0.0);
    if pixel.axis.w == 0u {
        let lobes = Lobes(false, vec4f(GROUND_SHARE, 0.0, 0.0, 0.0), vec4f(1.0));
        return Surroundings(LobeFrame(up, up, up), lobes);
    }
    let axis = bitcast<vec3f>(pixel.axis.xyz); // the normal, or the tangent
    let lobes = surface_lobes(rna_surface(rna_primitives[pixel.wo.w]));
    return Surroundings(lobe_frame(axis, axis, bitcast<vec3f>(pixel.wo.xyz)), lobes);
}

// The direction of queries for lobes. To the ground one by the cosine, with the irradiance in the view's colour.
fn mirrored(u: vec2f, pixel: Pixel) -> Arrival {
    if pixel.axis.w == 0u {
        let wi = normalize(along_axis(vec3f(0.0, 1.0, 0.0), 1.0 - 2.0 * u.y, u.x) + vec3f(0.0, 1.0001, 0.0));
        return Arrival(wi, view.colour / max(wi.y, 1e-3));
    }
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    let m = select(reflect(-wo, axis), reflect(wo, axis), rna_is_segment(rna_primitives[pixel.wo.w]));
    return Arrival(m, vec3f(1.0));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(number: u32, pixel: Pixel) -> Arrival {
    if view.kind == LIGHT_SUN {
        return Arrival(view.direction, view.colour);
    }
    if view.kind == LIGHT_GIVEN {
        return Arrival(bitcast<vec3f>(pixel.wi.xyz), view.colour);
    }
    let is_bright = view.kind == LIGHT_ENVIRONMENT;
    let u = at_point(number, select(DIRECTION, LIGHT, is_bright));
    if view.kind == LIGHT_MIRROR {
        return mirrored(u, pixel);
    }
    let about_point = surroundings_of(pixel);
    if is_bright {
        let bright = sample_image(0u, u);
        let pdf = lobe_density(about_point.at, about_point.lobes, bright.wi);
        return Arrival(bright.wi, bright.radiance / (bright.pdf + pdf));
    }
    let wi = lobe_sample(about_point.at, about_point.lobes, u.yx);
    let sky = look_up_image(0u, wi);
    let pdf = lobe_density(about_point.at, about_point.lobes, wi);
    return Arrival(wi, sky.radiance / (sky.pdf + pdf));
}

// Where rays of light start, the strand that they pass, and what is sent on of the light; of the ground how much it
// covers.
struct Start {
    x: vec3f,
    strand: u32,
    weight: vec3f,
    coverage: f32,
}

fn start_on_asset(pixel: Pixel, wi: vec3f) -> Start {
    let record = rna_primitives[pixel.wo.w];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, pixel.b1, pixel.b2);
        v.kind = OF_NEURAL;
    } else {
        v.x = bitcast<vec3f>(pixel.position.xyz);
        v.kind = OF_FIBERS;
        v.strand = rna_strand(record);
    }
    return Start(leaving_point(v, wi), v.strand, vec3f(1.0), 0.0);
}

// The ground, which the pixel's ray meets, shows the shadow and fades with the distance.
fn start_on_ground(pixel: Pixel, wi: vec3f) -> Start {
    let start = bitcast<vec3f>(pixel.position.xyz);
    let d = -bitcast<vec3f>(pixel.wo.xyz);
    if view.ground_size == 0.0 || d.y * (start.y - view.ground) >= 0.0 {
        return Start(vec3f(0.0), RNA_NOTHING, vec3f(0.0), 0.0);
    }
    let x = start + d * ((view.ground - start.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - view.middle) / view.ground_size);
    let weight = fade * max(0.0, wi.y) * view.ground_colour;
    let step = 0x1p-18f * rna_instances[0].extent;
    return Start(x + vec3f(0.0, step, 0.0), RNA_NOTHING, weight, fade);
}

@compute @workgroup_size(64)
fn light_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    var pixel = band[k];
    let number = view.first + k;
    let arrival = arrival_at(number, pixel);
    pixel.wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), 0u);
    let is_asset = pixel.axis.w != 0u;
    var start: Start;
    if is_asset {
        start = start_on_asset(pixel, arrival.wi);
    } else {
        start = start_on_ground(pixel, arrival.wi);
    }
    // Drivers inline each call, so the asset and the ground share those that trace.
    var visible = vec3f(0.0);
    var arriving = vec3f(0.0);
    if any(start.weight > vec3f(0.0)) {
        visible = start_visibility(0u, RnaRay(start.x, 0.0, arrival.wi, RNA_FAR), start.strand);
        arriving = past_glass(number, pixel, start.x, arrival);
    }
    if is_asset {
        pixel.visibility = visible;
        pixel.radiance = pixel.through * arriving;
    } else {
        let is_behind_glass = HAS_GLASS && pixel.axis.x == BENT_AWAY;
        pixel.radiance = start.weight * visible * arriving;
        if is_behind_glass {
            pixel.radiance = seen_behind_glass(pixel, pixel.radiance, start.coverage);
        }
        pixel.radiance *= pixel.through;
        pixel.coverage = select(start.coverage, 1.0, is_behind_glass);
    }
    band[k] = pixel;
}
`;var Fl=`// The first look without jagged edges, of the size of its light or larger: more rays a pixel, each with the light of the
// pixels nearby that saw what it sees.

@group(2) @binding(0) var<storage, read_write> seen: array<vec4<u32>>; // from pixels' middles: distance, axis, part + 1
@group(2) @binding(1) var<storage, read_write> look: array<vec4f>;

// Pixels of the light's picture:
const UNLIKE = 8.0; // weight of differences: of axes, and of distances to a plane in pixels
const APART = 3.0;  // and of the distance in the picture, pixels squared
const APART_ON_GROUND = 0.5; // whose light is noisy

fn raw_direction(place: vec2f) -> vec3f {
    return frame.corner + place.x * frame.step_x + place.y * frame.step_y;
}

// What the band's pixels see from their middles.
@compute @workgroup_size(64)
fn remember(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let pixel = band[k];
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let away = length(bitcast<vec3f>(pixel.position.xyz) - frame.camera);
    let packed = vec2<u32>(pack2x16snorm(axis.xy), pack2x16snorm(vec2f(axis.z, 0.0)));
    seen[view.first + k] = vec4<u32>(bitcast<u32>(away), packed, pixel.axis.w);
}

// How unlike what the light's pixel at \`place\` saw from its middle is to a hit of the same part.
fn difference(hit: Pixel, other: vec4<u32>, place: vec2f) -> f32 {
    if hit.axis.w == 0u {
        return 0.0;
    }
    let n = bitcast<vec3f>(hit.axis.xyz);
    let raw = raw_direction(place / view.light_scale);
    let away = bitcast<f32>(other.x);
    let x = frame.camera + away * normalize(raw);
    let size = away * length(frame.step_x) / view.light_scale.x / length(raw); // of a pixel there
    let off = abs(dot(n, x - bitcast<vec3f>(hit.position.xyz))) / max(size, 1e-30);
    return 1.0 - dot(n, vec3f(unpack2x16snorm(other.y), unpack2x16snorm(other.z).x)) + off;
}

// The light of the neighbours that are like the band's hit, whose ray went beside the middle by the view's shift.
fn light_beside(number: u32, hit: Pixel) -> vec4f {
    let pixel = vec2f(vec2<u32>(number % frame.width, number / frame.width));
    let place = (pixel + 0.5 + view.shift) * view.light_scale;
    let size = vec2<i32>(vec2<u32>(view.light_width, view.light_height));
    let middle = min(vec2<i32>(place), size - 1);
    let narrow = select(APART, APART_ON_GROUND, hit.axis.w == 0u);
    var sum = vec4f(0.0);
    var total = 0.0;
    for (var j = 0; j < 9; j++) {
        let at = middle + vec2<i32>(j % 3 - 1, j / 3 - 1);
        let there = u32(at.y) * view.light_width + u32(at.x);
        if any(at < vec2<i32>(0)) || any(at >= size) || seen[there].w != hit.axis.w {
            continue;
        }
        let apart = vec2f(at) + 0.5 - place;
        let unlike = min(difference(hit, seen[there], vec2f(at) + 0.5), 4.0);
        let weight = exp(-UNLIKE * unlike - narrow * dot(apart, apart));
        sum += weight * sums[there];
        total += weight;
    }
    if total == 0.0 {
        let there = u32(middle.y) * view.light_width + u32(middle.x);
        return select(sums[there], vec4f(0.0), hit.axis.w == 0u); // nobody saw such a thing
    }
    return sum / total;
}

// One of \`view.shares\` rays a pixel.
@compute @workgroup_size(64)
fn smooth_edges(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let before = select(look[number], vec4f(0.0), view.is_first == 1u);
    look[number] = before + light_beside(number, band[k]) / view.shares;
}
`;var Ti=`// The light of the whole environment that a part sends to the viewer, of each row: its lobes, by one look-up each in the
// prefiltered environment.

struct LobeLight {
    colour: vec3f, // of a texel of 1
    levels: f32,
    turn: vec2f,   // cosine and sine, as render/environment.wgsl turns an image
    least_kappa: f32, // of the first level
    an_octave: f32,   // levels
}

@group(1) @binding(0) var<storage, read> rows: array<RnaRow>; // wi: the mirror direction; blue: its visibility; red and green: Pixel.detail, halves
@group(1) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(1) @binding(2) var<storage, read> count: array<u32>; // [0]
@group(1) @binding(3) var<storage, read> columns: array<vec4f>; // 4 a row
@group(2) @binding(0) var<uniform> light: LobeLight;
@group(2) @binding(1) var prefiltered: texture_2d_array<f32>;
@group(2) @binding(2) var smooth_sampler: sampler;

fn mean_under(lobe: RnaLobe) -> vec3f {
    let d = lobe.axis;
    let x = light.turn.x * d.x - light.turn.y * d.z;
    let z = light.turn.y * d.x + light.turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    let azimuth = select(0.0, atan2(x, -z), sine > 0.0);
    let size = vec2f(textureDimensions(prefiltered));
    let polar = atan2(sine, d.y) / 3.14159265; // the first row is one pole, the last one the other
    let place = vec2f(0.5 + azimuth / 6.28318531, (polar * (size.y - 1.0) + 0.5) / size.y);
    let level = clamp(log2(lobe.kappa / light.least_kappa) * light.an_octave, 0.0, light.levels - 1.0);
    let wide = u32(level);
    let a = textureSampleLevel(prefiltered, smooth_sampler, place, wide, 0.0).xyz;
    let b = textureSampleLevel(prefiltered, smooth_sampler, place, min(wide + 1u, u32(light.levels) - 1u), 0.0).xyz;
    return mix(a, b, level - f32(wide));
}

@compute @workgroup_size(64)
fn light_by_lobes(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= count[0] {
        return;
    }
    let at = rows[row];
    let axis = bitcast<vec3f>(at.axis);
    let wo = bitcast<vec3f>(at.wo);
    let m = bitcast<vec3f>(at.wi);
    var visibility: array<vec4f, 4>;
    for (var k = 0u; k < 4u; k++) {
        visibility[k] = columns[4u * row + k];
    }
    let place = rna_run_lobes(bitcast<vec3f>(at.position), axis, bitcast<f32>(at.h), wo, m, visibility);
    let detail = vec3f(unpack2x16float(at.red), unpack2x16float(at.green).x);
    var sum = vec3f(0.0);
    for (var j = 0u; j < RNA_LOBES; j++) {
        let lobe = rna_lobe(place, j, axis, wo, m, bitcast<f32>(at.blue));
        sum += lobe.amplitude * select(vec3f(1.0), detail, j < RNA_LOBES / 2u) * mean_under(lobe);
    }
    answers[row] = vec4f(light.colour * sum, 0.0);
}
`;var Cl=`// Glass beside the asset, where rays of light start and where the camera looks.

const HAS_GLASS = true;

// What comes along wi to x, where glass may be in the way: rays that follow it through find the environment; the other
// sorts of light do not pass.
fn past_glass(number: u32, pixel: Pixel, x: vec3f, arrival: Arrival) -> vec3f {
    let ray = RnaRay(x, 0.0, arrival.wi, RNA_FAR);
    if view.kind != LIGHT_AROUND_POINT {
        start_passing(ALL_STOP);
        let is_hidden = rna_trace(ray, 0u, frame.rays, true).instance != RNA_NOTHING;
        return select(arrival.radiance, vec3f(0.0), is_hidden);
    }
    let followed = follow(ray, 0u, 1u, number);
    if !followed.bent {
        return arrival.radiance;
    }
    if followed.hit.instance != RNA_NOTHING {
        return vec3f(0.0);
    }
    let sky = look_up_image(0u, followed.ray.direction).radiance;
    let about_point = surroundings_of(pixel);
    return followed.weight * sky / lobe_density(about_point.at, about_point.lobes, arrival.wi);
}

// What a ray that comes out of glass and meets nothing sees: the ground, and beyond it the environment.
fn seen_behind_glass(pixel: Pixel, ground: vec3f, coverage: f32) -> vec3f {
    if view.kind != LIGHT_ENVIRONMENT {
        return ground;
    }
    return ground + (1.0 - coverage) * look_up_image(0u, -bitcast<vec3f>(pixel.wo.xyz)).radiance;
}
`;var zl=`// Nearby light of one part's pixels, along the directions of light that light_pixels has drawn. All lights are far away.

@compute @workgroup_size(64)
fn find_nearby(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part {
        return;
    }
    let x = bitcast<vec3f>(band[k].position.xyz);
    let wi = bitcast<vec3f>(band[k].wi.xyz);
    let u = at_point(view.first + k, NEARBY + LIGHT + view.number);
    start_passing(PASS_MOST);
    band[k].nearby = nearby_light(rna_instances[0].root, view.lengths, x, wi, RNA_FAR, u);
}
`;var Oi=`// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

@group(2) @binding(0) var<storage, read_write> rows: array<RnaRow>;
@group(2) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> count: array<atomic<u32>>; // [0]; then the pixel of each row

// What a light brings to the ground, and the coverage. \`sums\` are of the whole picture.
@compute @workgroup_size(64)
fn begin(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let is_query = band[k].axis.w != 0u;
    let covered = select(band[k].coverage, 1.0, is_query) * f32(view.counts_coverage);
    let before = select(sums[view.first + k], vec4f(0.0), view.is_first == 1u);
    sums[view.first + k] = before + vec4f(select(band[k].radiance, vec3f(0.0), is_query), covered);
}

// Whether a decoder, of visible or of shadowed light alone, adds something there.
fn counts(visibility: vec3f) -> bool {
    if view.form == FORM_VISIBLE {
        return any(visibility > vec3f(0.0));
    }
    return view.form != FORM_SHADOWED || any(visibility < vec3f(1.0));
}

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part || !counts(band[k].visibility) {
        return;
    }
    let pixel = band[k];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], k);
    // No block of emission reads wi.
    let wi = select(pixel.wi, pixel.wo, view.form == FORM_EMISSION);
    let free = dot(pixel.visibility, vec3f(1.0 / 3.0)); // read with lobes alone
    let color = bitcast<vec3<u32>>(pixel.base_color);
    let detail = vec3<u32>(pack2x16float(pixel.detail.xy), pack2x16float(pixel.detail.zz), bitcast<u32>(free));
    let more = select(color, detail, view.form == FORM_ENVIRONMENT);
    rows[at] = RnaRow(
        pixel.position.xyz, pixel.position.w, pixel.axis.xyz, more.x, pixel.wo.xyz, more.y, wi.xyz, more.z,
        bitcast<vec3<u32>>(pixel.nearby), 1u,
    );
}

@compute @workgroup_size(64)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= atomicLoad(&count[0]) {
        return;
    }
    let k = atomicLoad(&count[at + 1u]);
    let pixel = band[k];
    var radiance = pixel.through * answers[at].xyz;
    if view.form <= FORM_SHADOWED {
        var transport = vec3f(0.0);
        if view.form != FORM_SHADOWED {
            transport = pixel.visibility * answers[2u * at].xyz;
        }
        if view.form != FORM_VISIBLE {
            transport += (1.0 - pixel.visibility) * answers[2u * at + select(0u, 1u, view.form == FORM_TRANSPORT)].xyz;
        }
        radiance = pixel.radiance * transport;
    }
    sums[view.first + k] += vec4f(radiance, 0.0);
}
`;var Mi=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB, alpha
// where the page behind it shows.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec4f, // linear light of the screen, and 1; or zeros, where the page shows
    rounds: f32,
    exposure: f32,  // a factor
    filmic: f32,    // 1 for the filmic view transform, 0 for none
    spread: f32,    // of noise, in values of the screen; 0 to leave it
    first_look: f32, // share of the first look in what is shown, 0 to 1
    rows_ahead: f32, // from the top, which have one sample more than \`rounds\`
    corner: vec3f, // of the view, the ray through its upper left
    across: vec3f, // its width, and its height below
    down: vec3f,
    sky_size: vec2f, // of the environment's image
    sky_turn: vec2f, // cosine and sine of its turn about +y
    sky: f32, // what its radiance is multiplied by; 0 where it is not behind the asset
    sky_texels: u32, // where they begin
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;
@group(0) @binding(2) var<storage, read> first_look: array<vec4f>; // the first look
@group(0) @binding(3) var<storage, read> images: array<f32>;

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

// The mean of the samples and the first look.
fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    let k = place.y * u32(shown.picture.x) + place.x;
    if shown.first_look >= 1.0 {
        return first_look[k];
    }
    let mean = sums[k] / (shown.rounds + f32(f32(place.y) < shown.rows_ahead));
    if shown.first_look <= 0.0 {
        return mean;
    }
    return mix(mean, first_look[k], shown.first_look);
}

// As rna_render/image/view_transform.py, which names the source.
fn filmic(radiance: vec3f) -> vec3f {
    let c = 1.461926 * min(radiance, vec3f(1e9));
    let x = vec3f(dot(c, vec3f(0.59719, 0.35458, 0.04823)), dot(c, vec3f(0.07600, 0.90834, 0.01566)),
                  dot(c, vec3f(0.02840, 0.13383, 0.83777)));
    // Both parts divided by x, so that none overflows.
    let inverse = 1.0 / max(x, vec3f(1e-9));
    let y = (x + 0.0245786 - 0.000090537 * inverse) / (0.983729 * x + 0.4329510 + 0.238081 * inverse);
    return vec3f(dot(y, vec3f(1.60475, -0.53108, -0.07367)), dot(y, vec3f(-0.10208, 1.10813, -0.00605)),
                 dot(y, vec3f(-0.00327, -0.07276, 1.07602)));
}

fn sky_texel(row: f32, column: f32) -> vec3f {
    let wide = u32(shown.sky_size.x);
    let at = shown.sky_texels + 3u * (u32(clamp(row, 0.0, shown.sky_size.y - 1.0)) * wide + (u32(column + shown.sky_size.x) % wide));
    return vec3f(images[at], images[at + 1u], images[at + 2u]);
}

// Radiance of the environment behind a place of the view, in shares from the upper left.
fn sky_behind(place: vec2f) -> vec3f {
    let v = normalize(shown.corner + place.x * shown.across + place.y * shown.down);
    let d = vec3f(shown.sky_turn.x * v.x - shown.sky_turn.y * v.z, v.y, shown.sky_turn.x * v.z + shown.sky_turn.y * v.x);
    let turns = vec2f(atan2(d.x, -d.z) / 6.2831853 + 0.5, acos(clamp(d.y, -1.0, 1.0)) / 3.1415927);
    let texel = turns * shown.sky_size - 0.5;
    let low = floor(texel);
    let f = texel - low;
    let above = mix(sky_texel(low.y, low.x), sky_texel(low.y, low.x + 1.0), f.x);
    return shown.sky * mix(above, mix(sky_texel(low.y + 1.0, low.x), sky_texel(low.y + 1.0, low.x + 1.0), f.x), f.y);
}

// Values of the screen, sRGB, premultiplied, of a mean, with what is behind it.
fn displayed(asset: vec4f, sky: vec3f) -> vec4f {
    let mean = select(asset, vec4f(asset.xyz + max(0.0, 1.0 - asset.w) * sky, 1.0), shown.sky > 0.0);
    let exposed = max(mean.xyz * shown.exposure, vec3f(0.0));
    let light = select(exposed, filmic(exposed), shown.filmic > 0.5);
    let behind = max(0.0, 1.0 - mean.w) * shown.backdrop.w;
    let alpha = min(mean.w, 1.0) + behind;
    let linear = (clamp(light, vec3f(0.0), vec3f(1.0)) + behind * shown.backdrop.xyz) / max(alpha, 1e-4);
    let encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3f(1.0 / 2.4)) - 0.055, step(vec3f(0.0031308), linear));
    return vec4f(clamp(encoded, vec3f(0.0), vec3f(1.0)), 1.0) * alpha;
}

@fragment
fn colour(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy * shown.picture / shown.size - 0.5;
    let low = floor(place);
    let f = place - low;
    let above = mix(picture_at(low.x, low.y), picture_at(low.x + 1.0, low.y), f.x);
    let below = mix(picture_at(low.x, low.y + 1.0), picture_at(low.x + 1.0, low.y + 1.0), f.x);
    let mean = mix(above, below, f.y);
    var sky = vec3f(0.0);
    if shown.sky > 0.0 {
        sky = sky_behind(at.xy / shown.size);
    }
    let here = displayed(mean, sky);
    if (shown.spread == 0.0) {
        return here;
    }
    // Bilateral: neighbours count by how near and how like they are.
    var sum = here;
    var total = 1.0;
    let middle = round(place);
    for (var dy = -2.0; dy <= 2.0; dy += 1.0) {
        for (var dx = -2.0; dx <= 2.0; dx += 1.0) {
            let there = middle + vec2f(dx, dy);
            let other = picture_at(there.x, there.y);
            let value = displayed(other, sky);
            let away = there - place;
            let unlike = (value - here) / shown.spread;
            let edge = 4.0 * (other.w - mean.w);
            let weight = exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
            sum += weight * value;
            total += weight;
        }
    }
    return sum / total;
}
`;var Ul=`// What render/solid_glass.wgsl has, for assets without glass beside them.

struct Followed {
    hit: RnaHit,
    weight: vec3f,
    bent: bool,
    ray: RnaRay,
}

fn follow(start: RnaRay, ignored: u32, depth: u32, pixel: u32) -> Followed {
    let through = closest_through(start, ignored, frame.rays, chance_of(pixel));
    return Followed(through.hit, through.weight, false, start);
}
`;var Dl=`// What past_glass.wgsl has, for assets without glass beside them.

const HAS_GLASS = false;

fn past_glass(number: u32, pixel: Pixel, x: vec3f, arrival: Arrival) -> vec3f {
    return arrival.radiance;
}

fn seen_behind_glass(pixel: Pixel, ground: vec3f, coverage: f32) -> vec3f {
    return ground;
}
`;var Bl=`// What segment.wgsl has, for assets without strands: code that an asset has no use for is not compiled, which takes
// most of the time to its first picture.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

struct RnaEntry {
    t: f32,
    u: f32,
    normal: vec3f,
}

fn rna_cone(point: u32) -> RnaCone {
    return RnaCone(vec3f(0.0), 0.0, vec3f(0.0), 0.0);
}

fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    return RNA_FAR;
}

fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    return RnaEntry(RNA_FAR, 0.0, vec3f(0.0));
}
`;var Hl=`// What render/base_color.wgsl has, for assets without it.

fn base_color_on(record: RnaPrimitive, b1: f32, b2: f32, width: f32) -> vec3f {
    return vec3f(1.0);
}

fn base_color_of_level(record: RnaPrimitive, b1: f32, b2: f32, level: f32) -> vec3f {
    return vec3f(1.0);
}
`;var Gl=`// What normal_maps.wgsl and render/transmittance.wgsl have, for assets without textures.

fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    return n;
}

fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    return vec3f(0.0);
}
`;for(let r of[Et,Ti,Oi,Mi])sa(r);var $l=r=>r in At?[r]:xt[r].flatMap($l),Dt=(r,e=At)=>[...new Set(r.flatMap($l))].map(t=>e[t]).join(`
`);function Vr(r,...e){return Object.entries(r).map(([n,s])=>`const ${n}: u32 = ${s}u;
`).join("")+Dt(e)}function Wr({hasSegments:r,hasTextures:e,hasBaseColor:t,hasGlass:n}){let s={...At};r||(s["segment.wgsl"]=Bl),e||Object.assign(s,{"normal_maps.wgsl":Gl,"render/transmittance.wgsl":""}),n||(s["render/solid_glass.wgsl"]=Ul),t||(s["render/base_color.wgsl"]=Hl);let i=[Dt(xt.light,s),Et,ia,Pl,n?Cl:Dl];return{hit:Dt(xt.hit,s)+Et+Ll,light:i.join(`
`),nearby:Dt(xt.nearby,s)+Et+zl}}var Bt={columns:Dt(xt.columns)+Et+Ml,lobes:`${At["environment_lobes.wgsl"]}
${At["row_records.wgsl"]}
${Ti}`,look:Dt(xt.queue)+Et+Fl,queue:Dt(xt.queue)+Et+Oi,show:Mi};var Zr=class{constructor(e){this.device=e,this.made=new Map}get(e,t,n){let s=`${t}
${e}`;return this.made.has(s)||this.made.set(s,this._make(e,t,n)),this.made.get(s)}async _make(e,t,n){let s=await Ur(this.device,e),i=n?this.device.createPipelineLayout({bindGroupLayouts:n}):"auto";return this.device.createComputePipelineAsync({layout:i,compute:{module:s,entryPoint:t}})}},mn=class{static make(e,t,n,s,i){let a=n.decoders[s],l={constants:{RNA_COLOURS:a.colours,RNA_STRIDE:s==="emission"?1:2,RNA_FIRST:0},parts:[n.kind,"evaluate"],kernel:"",entryPoint:"rna_evaluate"};return this.of(e,t,jr(n,a,a.inputs),i,l)}static async of(e,t,{weights:n,record:s,groups:i},a,{constants:o,parts:l,kernel:u,entryPoint:f}){let p=new this,{UNIFORM_WEIGHTS:m}=oe,g=n.length/4<=m,_=g?"weights_uniform.wgsl":"weights_storage.wgsl";p.pipeline=await t.get(Vr({RNA_GROUPS:i,...o},_,...l)+u,f);let{UNIFORM:w,STORAGE:A}=GPUBufferUsage,T=g?new Float32Array(4*m):n;return g&&T.set(n),p.buffers=[se(e,s,w,"a decoder"),se(e,T,g?w:A,"a decoder")],p.part=Fn(e,p.pipeline,0,[...p.buffers,...a]),p.device=e,p}run(e,{rows:t,answers:n,count:s},i){this.dispatch(e,[t,n,s],i)}dispatch(e,t,n,s=[]){this.bound??=Fn(this.device,this.pipeline,1,t),ge(e,this.pipeline,[this.part,this.bound,...s],n)}delete(){for(let e of this.buffers)e.destroy()}};function*ql(r,[e,t]){let n=e+1,s=r.reduce((o,l)=>o+l,0)/r.length||1,i=yield*Gp(r,e,t,s),a=new Uint16Array(4*t*n*19);for(let o=0;o<19;o++){let l=.25*2**(o/2);for(let u=0;u<n;u++){let f=$p(i,Math.PI*u/e,e,t/2,l);jp(a,4*t*(o*n+u),f,t),yield}}return{texels:a,width:t,height:n,levels:19,unit:s}}var jl=r=>Float64Array.from({length:r},(e,t)=>Math.cos(2*Math.PI*t/r)),Vl=(r,e)=>2*Math.PI*(Math.cos(Math.PI*r/e)-Math.cos(Math.PI*(r+1)/e));function*Gp(r,e,t,n){let s=t/2,i=new Float64Array(6*e*s),a=jl(t);for(let o=0;o<e;o++){yield;let l=Vl(o,e)/t;for(let u=0;u<s;u++)for(let f=0;f<t;f++){let p=u*f,m=6*(o*s+u),g=3*(o*t+f),_=l/n*a[p%t],w=l/n*a[(p+.75*t)%t];for(let A=0;A<3;A++)i[m+A]+=r[g+A]*_,i[m+3+A]+=r[g+A]*w}}return i}function $p(r,e,t,n,s){let i=new Float64Array(6*n),a=new Float64Array(n),o=0;for(let l=0;l<t;l++){let u=Math.PI*(l+.5)/t,f=Math.exp(s*(Math.cos(e-u)-1));if(!(f<1e-6)){qp(s*Math.sin(e)*Math.sin(u),a),o+=f*a[0]*Vl(l,t);for(let p=0;p<n&&a[p]>1e-6;p++){let m=f*a[p]*(p?2:1),g=6*(n*l+p),_=6*p;for(let w=0;w<6;w++)i[_+w]+=m*r[g+w]}}}return i.map(l=>l/o)}function qp(r,e){let t=Math.min(e.length-1,Math.ceil(8+6*Math.sqrt(r))),n=0;for(let a=t+8;a>0;a--)n=r/(2*a+r*n),a<=t&&(e[a]=n);let s=1,i=1;for(let a=1;a<=t;a++)s*=e[a],e[a]=s,i+=2*s;e[0]=1;for(let a=0;a<=t;a++)e[a]/=i;e.fill(0,t+1)}function jp(r,e,t,n){let s=jl(n),i=n/2;for(;i>1&&t.subarray(6*i-6,6*i).every(a=>Math.abs(a)<1e-6);)i-=1;for(let a=0;a<n;a++){let o=0,l=0,u=0;for(let f=0,p=0,m=0;f<i;f++,p=(p+a)%n,m+=6){let g=s[p],_=s[(p+.75*n)%n];o+=t[m]*g+t[m+3]*_,l+=t[m+1]*g+t[m+4]*_,u+=t[m+2]*g+t[m+5]*_}[o,l,u].forEach((f,p)=>{r[e+4*a+p]=Wp(f)})}}var Wl=new Float32Array(1),Vp=new Uint32Array(Wl.buffer);function Wp(r){return Wl[0]=Math.max(r,0),Math.max(0,Math.min(31743,(Vp[0]+4096>>>13)-114688))}var[Zl,Yl,Li]=["uniform","storage","read-only-storage"],Yr=class{constructor(e){let{device:t,bandPixels:n}=e;Object.assign(this,{device:t,engine:e,rest:null}),this.columns=se(t,4*ln*n),this.record=se(t,ot("LobeLight"),GPUBufferUsage.UNIFORM),this.layouts=[Pe(t,{0:Zl}),Pe(t,{0:Yl,1:Zl}),Pe(t,{0:Li,1:Li,2:Li,3:Yl})],this.sampler=t.createSampler({addressModeU:"repeat",magFilter:"linear",minFilter:"linear"})}async begin(e,t){let n=new Int8Array(4*e.points.length);t.forEach(({environment:s},i)=>n.set(s.harmonics??[],16*e.parts[i].point)),this.harmonics=se(this.device,n,void 0,"the asset's visibility"),this.columnKernel=await this.engine.pipelines.get(Bt.columns,"write_visibility",this.layouts)}set({rest:e,turn:t,radiance:n}){let{device:s}=this,{texels:i,width:a,height:o,levels:l,unit:u}=e;this.rest!==e&&(this.texture?.destroy(),this.texture=s.createTexture({size:[a,o,l],format:"rgba16float",usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST}),s.queue.writeTexture({texture:this.texture},i,{bytesPerRow:8*a,rowsPerImage:o},[a,o,l]),this.rest=e),s.queue.writeBuffer(this.record,0,pe("LobeLight",{colour:n.map(f=>f*u),levels:l,turn:[Math.cos(t),Math.sin(t)],least_kappa:.25,an_octave:2}))}run(e,{count:t},n){let{engine:{frameRecord:s,band:i,viewRecord:a,geometry:o},device:l,layouts:u}=this;this.groups??=[[s],[i,a],[t,o[1],this.harmonics,this.columns]].map((f,p)=>He(l,u[p],f)),ge(e,this.columnKernel,this.groups,n)}delete(){for(let e of[this.harmonics,this.columns,this.record,this.texture])e?.destroy()}},Kr=class extends mn{static async make(e,t,n,s,i){let{environment:a}=n,o=a.harmonics?ln:0,l=await super.of(e,t,jr({...n,planes:a.planes},a,a.inputs,o),s,{constants:{RNA_LOBES:a.lobes,RNA_IS_FIBER:+(n.kind==="fiber"),RNA_VISIBILITY_GROUPS:o/4},parts:[n.kind],kernel:Bt.lobes,entryPoint:"light_by_lobes"});return Object.assign(l,{shared:i})}run(e,t,n){let{shared:s,device:i,pipeline:a}=this;if(s.run(e,t,n),this.texture!==s.texture){this.texture=s.texture;let o=[{buffer:s.record},s.texture.createView({dimension:"2d-array"}),s.sampler];this.lit=i.createBindGroup({layout:a.getBindGroupLayout(2),entries:o.map((l,u)=>({binding:u,resource:l}))})}this.dispatch(e,[t.rows,t.answers,t.count,s.columns],n,[this.lit])}};var zn=1<<17,Yp=["transport","visible","shadowed","emission","environment"],Kp=["transport","visible","shadowed"],Xr=class r{static async open(e){let t=new r,n=await dl();Object.assign(t,{canvas:e,device:n,parts:[],lost:!1,bandPixels:zn}),n.lost.then(({reason:i,message:a})=>{t.lost=!0,t.closed||t.onlost?.(`the GPU was lost (${a||i})`)}),n.addEventListener("uncapturederror",({error:i})=>{t.error??=i}),t.context=e.getContext("webgpu");let s=navigator.gpu.getPreferredCanvasFormat();return t.context.configure({device:n,format:s,alphaMode:"premultiplied",usage:GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.COPY_SRC}),t.pipelines=new Zr(n),t.compiled=t._compile(s),t.compiled.catch(()=>{}),t}async _compile(e){let{device:t}=this,n=await Ur(t,Bt.show),[s,i,a]=["uniform","storage","read-only-storage"],o=Pe(t,{0:i,1:s});this.rayLayout=[Pe(t,{0:s,4:a,5:a}),o,Pe(t,{0:a,1:a,2:a,3:a,4:a})],this.queueLayout=[Pe(t,{0:s,2:i}),o,Pe(t,{0:i,1:i,2:i})],this.lookLayout=[...this.queueLayout.slice(0,2),Pe(t,{0:i,1:i})];let[l,u,f,p]=await Promise.all([...["begin","gather","scatter"].map(m=>this.pipelines.get(Bt.queue,m,this.queueLayout)),t.createRenderPipelineAsync({layout:"auto",vertex:{module:n,entryPoint:"corner"},fragment:{module:n,entryPoint:"colour",targets:[{format:e}]}})]);Object.assign(this,{queueKernels:{begin:l,gather:u,scatter:f},shown:p}),this._makeBand()}_makeBand(){let{device:e}=this,{UNIFORM:t}=GPUBufferUsage;this.frameRecord=se(e,pe("Frame",{}),t),this.viewRecord=se(e,ot("View"),t),this.showRecord=se(e,ot("Show"),t),this.band=se(e,ot("Pixel")*zn),this.queue={rows:se(e,ot("RnaRow")*zn),answers:se(e,32*zn),count:se(e,4*(zn+4))},this._bind()}async setAsset(e,{parts:t,glass:n}){this._deleteAsset(),await this.compiled;let s=!n&&t.every(({environment:l})=>l);this.lobeLight=s?new Yr(this):null;let i=Promise.all(t.map(l=>this._makePart(l))),a=Promise.all([i,this._compileKernels(t,!!n,s),this._storeGeometry(e,t)]);a.catch(()=>i.then(l=>l.forEach(Kl)).catch(()=>{}));let[o]=await a;Object.assign(this,{parts:o,hasLobes:s,texel:s?Math.max(...t.map(Jp)):0}),this._makeSums()}async _storeGeometry(e,t){let n=await e;performance.mark("hierarchy");let{device:s}=this,i=(a,o)=>se(s,a,void 0,`the asset's ${o}`);this.geometry=[i(n.nodes,"hierarchy"),i(n.primitives,"geometry"),i(n.points,"geometry"),i(em(n),"geometry"),i(n.normals,"geometry")],this._storeSurfaces(n),await this.lobeLight?.begin(n,t)}async _compileKernels(e,t,n){let{pipelines:s}=this,i=g=>e.some(g);this.raySources=Wr({hasSegments:i(({kind:g})=>g==="fiber"),hasTextures:i(Xp),hasBaseColor:i(Qp),hasGlass:t});let a=n?["remember","smooth_edges"]:[],o=i(({lengths:g})=>g),[l,u,f,p,m]=await Promise.all([s.get(this.raySources.hit,"trace_pixels",this.rayLayout),s.get(this.raySources.light,"light_pixels",this.rayLayout),o&&s.get(this.raySources.nearby,"find_nearby",this.rayLayout),...a.map(g=>s.get(Bt.look,g,this.lookLayout))]);this.kernels={hit:l,light:u,nearby:f,remember:p,smooth:m,...this.queueKernels}}async _makePart(e){let{device:t,pipelines:n}=this,s=p=>[0,1,2].map(m=>se(t,Ol(p,m),void 0,"a plane of features")),i=s(e.planes),a=e.environment,o=this.lobeLight&&a.planes!==e.planes?s(a.planes):null,l=Object.keys(e.decoders),[u,...f]=await Promise.all([this.lobeLight&&Kr.make(t,n,e,o??i,this.lobeLight),...l.map(p=>mn.make(t,n,e,p,i))]);return{lengths:e.lengths,planes:[...i,...o??[]],environment:u,...Object.fromEntries(l.map((p,m)=>[p,f[m]]))}}get emits(){return this.parts.some(({emission:e})=>e)}setSurfaces(e){this.geometry&&(this._storeSurfaces(e),this._bind())}_storeSurfaces(e){let{device:t}=this,{table:n}=e;this.table?.destroy(),this.table=se(t,4*n.length+ot("Light")),t.queue.writeBuffer(this.table,0,n),Object.assign(this,{arrays:e,lightsAt:n.length/4}),this._storeImages()}setEnvironment(e){this.environment=e,this._storeImages(),this._bind()}_storeImages(){if(!this.geometry)return;let{images:e}=this.arrays,t=this.environment?.floats??new Float32Array(0);this.images?.destroy(),this.images=se(this.device,4*(e.length+t.length),void 0,"the store of images"),this.device.queue.writeBuffer(this.images,0,e),this.device.queue.writeBuffer(this.images,4*e.length,t)}resize(e,t){this.target={width:e,height:t};let n=Math.max(e*t,this.hasLobes?this.canvas.width*this.canvas.height:0);this.sums&&n<=this.capacity&&n*8>=this.capacity||(this.capacity=n,this._makeSums())}_makeSums(){if(!this.capacity)return;for(let n of[this.sums,this.firstLook,this.seen])n?.destroy();let e=n=>se(this.device,16*n,void 0,"the picture"),t=this.hasLobes?this.capacity:1;Object.assign(this,{sums:e(this.capacity),firstLook:e(t),seen:e(t)}),this._bind()}_bind(){if(!this.geometry||!this.sums||!this.band||!this.kernels)return;let{device:e,rayLayout:t,queueLayout:n,queue:s}=this,i=He(e,t[1],{0:this.band,1:this.viewRecord}),a=He(e,n[2],[s.rows,s.answers,s.count]),o=He(e,n[0],{0:this.frameRecord,2:this.sums});this.groups={rays:[He(e,t[0],{0:this.frameRecord,4:this.table,5:this.images}),i,He(e,t[2],this.geometry)],queue:[o,i,a],look:[o,i,He(e,this.lookLayout[2],[this.seen,this.firstLook])],show:Fn(e,this.shown,0,[this.showRecord,this.sums,this.firstLook,this.images])}}trace(e,t,n,s,i=this.target.width){this.span={first:n*i,pixels:(s-n)*i,jitter:e.jitter??1,shift:e.shift??[0,0]},this._writeFrame(e,t,i),this._writeView({}),this._run(a=>ge(a,this.kernels.hit,this.groups.rays,this.span.pixels))}light(e,{isFirst:t,countsCoverage:n,number:s}){this._writeLight(e),this.view={...e,isFirst:t,countsCoverage:n,number:s},this._writeView(this.view),this._run(i=>{ge(i,this.kernels.light,this.groups.rays,this.span.pixels),ge(i,this.kernels.begin,this.groups.queue,this.span.pixels)}),e.kind==="mirror"?this.lobeLight.set(e):this._findNearby();for(let i of e.kind==="mirror"?["environment"]:Kp)this._decode(i)}emission(){this._decode("emission")}remember(){this._run(e=>ge(e,this.kernels.remember,this.groups.look,this.span.pixels))}smoothEdges(e,t,n){this._writeView({shares:e,isFirst:t,size:n}),this._run(s=>ge(s,this.kernels.smooth,this.groups.look,this.span.pixels))}show({rounds:e,firstLook:t,rowsAhead:n,exposure:s,backdrop:i,filmic:a,spread:o,camera:l,sky:u}){let{width:f,height:p}=l,{canvas:m,device:g}=this;g.queue.writeBuffer(this.showRecord,0,pe("Show",{size:[m.width,m.height],picture:[f,p],backdrop:i,rounds:e,rows_ahead:n,exposure:s,filmic:Number(a),spread:o,first_look:t,...u&&this._sky(l,u)}));let _=g.createCommandEncoder(),w=this.context.getCurrentTexture().createView(),A=_.beginRenderPass({colorAttachments:[{view:w,loadOp:"clear",storeOp:"store"}]});A.setPipeline(this.shown),A.setBindGroup(0,this.groups.show),A.draw(3),A.end(),g.queue.submit([_.finish()])}_sky({corner:e,stepX:t,stepY:n,width:s,height:i},{strength:a,angle:o}){let{environment:l,arrays:u}=this,{places:f}=l;return{corner:e,across:t.map(p=>p*s),down:n.map(p=>p*i),sky:a,sky_size:[l.width,l.height],sky_turn:[Math.cos(o),Math.sin(o)],sky_texels:u.images.length+f[0]}}async done(){if(await this.device.queue.onSubmittedWorkDone(),this.error)throw this.error}async picture(){let{width:e,height:t}=this.target;return new Float32Array(await Cn(this.device,this.sums,16*e*t))}_findNearby(){for(let[e,{lengths:t}]of this.parts.entries())t&&(this._writeView({...this.view,part:e+1,lengths:t}),this._run(n=>ge(n,this.kernels.nearby,this.groups.rays,this.span.pixels)))}_decode(e){for(let[t,n]of this.parts.entries()){let s=n[e];s&&(this._writeView({...this.view,part:t+1,form:Yp.indexOf(e)}),this.device.queue.writeBuffer(this.queue.count,0,Uint32Array.of(0)),this._run(i=>{ge(i,this.kernels.gather,this.groups.queue,this.span.pixels),s.run(i,this.queue,this.span.pixels),ge(i,this.kernels.scatter,this.groups.queue,this.span.pixels)}))}}_run(e){let t=this.device.createCommandEncoder(),n=t.beginComputePass();e(n),n.end(),this.device.queue.submit([t.finish()])}_writeFrame({position:e,corner:t,stepX:n,stepY:s},i,a){let{lightsAt:o,arrays:l,span:u}=this;this.device.queue.writeBuffer(this.frameRecord,0,pe("Frame",{camera:e,corner:t,step_x:n,step_y:s,width:a,paths:u.pixels,sample:i,branches:1,depth:1,rays:oe.CAMERA_RAY,flags:l.transmits?oe.TRANSMITS:0,textures:l.texturesAt,lights:o,spread:Math.hypot(...s)/Math.sqrt(u.jitter>0?i+1:1)}))}_writeView({kind:e="sun",direction:t=[0,0,0],colour:n=[0,0,0],ground:s,isFirst:i=!1,countsCoverage:a=!1,part:o=0,form:l=0,shares:u=1,size:f=this.target,lengths:p=[0,0,0],number:m=0}){let{first:g,jitter:_,shift:w=[0,0]}=this.span,{width:A,height:T}=this.target,F=s&&{ground:s.height,ground_colour:s.colour,ground_size:s.size,middle:[s.x,s.z]};this.device.queue.writeBuffer(this.viewRecord,0,pe("View",{first:g,jitter:_,kind:Es[e],is_first:Number(i),direction:t,counts_coverage:Number(a),colour:n,part:o,form:l,shift:w,shares:u,texel:this.texel??0,light_width:A,light_height:T,light_scale:[A/f.width,T/f.height],lengths:p,number:m,...F}))}_writeLight({angle:e,colour:t}){if(e===void 0)return;let{width:n,height:s,total:i,places:a}=this.environment,o={turn_cosine:Math.cos(e),turn_sine:Math.sin(e)},l=aa("image",{colour:t,...o,total:i,rows:s,columns:n});this.device.queue.writeBuffer(this.table,16*this.lightsAt,pe("Light",{kind:oe.IMAGE,group:oe.NONE,numbers:l,places:a.map(u=>u+this.arrays.images.length)}))}_deleteAsset(){for(let e of[...this.geometry??[],this.table,this.images])e?.destroy();this.lobeLight?.delete(),this.parts.forEach(Kl),this.parts=[],this.geometry=this.images=this.table=null}close(){this.closed=!0,this._deleteAsset(),this.device.destroy()}};function Kl({lengths:r,planes:e,...t}){e.forEach(n=>n.destroy());for(let n of Object.values(t))n?.delete()}var Xp=({transmittance:r,normalMaps:e})=>r.length+e.length>0,Jp=({bounds:{min:r,max:e},environment:t})=>Math.max(...e.map((n,s)=>n-r[s]))/t.planes.resolution,Qp=({baseColor:r})=>r.length>0;function em({glassRoot:r,extent:e}){let t={to_object:[1,0,0,0,0,1,0,0,0,0,1,0],rotation:[1,0,0,0,0,1,0,0,0,0,1,0],scale:1},n=oe.CAMERA_RAY|oe.INDIRECT_RAY,s=[1,r??1].map(i=>pe("RnaInstance",{...t,root:i,rays:n,extent:e}));return Uint32Array.from(s.flatMap(i=>[...i]))}function Xl(r,e){let{cameraControls:t,disableZoom:n,wheelZoom:s}=r.settings;if(!t||e.type!=="wheel")return t;let i=r.place.getRootNode().activeElement===r.canvas;return!n&&(s==="always"||i||e.ctrlKey||e.metaKey)}function Jl(r){let e=(t,n)=>(...s)=>{r.settings[n]||(r.glide.stop(),t(...s),r.isTouched=!0,r.restart(s.at(-1)===!0),r.emit("camera",{byUser:!0}))};return{orbit:e((t,n)=>r.orbit.turn(t,n)),pan:e((t,n)=>r.orbit.pan(t,n),"disablePan"),zoom:e(t=>r.orbit.zoom(t),"disableZoom"),light:(t,n,s)=>{if(r.settings.disableLight)return;let i=rr(r.lighting.rotation+t*180/Math.PI),a=We(r.lighting.sunHeight+n*180/Math.PI,-10,90);r.setLight({rotation:i,sunHeight:a},{moving:s===!0,byUser:!0})},remember:()=>tm(r),settle:()=>r.viewer?.moving&&r.restart(),reset:()=>r.glideTo(()=>r.reset())}}function tm(r){let{orbit:e,lighting:t,isTouched:n}=r,{azimuth:s,elevation:i,distance:a,target:o}=e,{rotation:l,sunHeight:u}=t,f={azimuth:s,elevation:i,distance:a,target:o},p={rotation:l,sunHeight:u},m=(g,_)=>Object.keys(_).some(w=>g[w]!==_[w]);return()=>{m(t,p)&&r.setLight(p),m(e,f)&&(Object.assign(e,f),r.isTouched=n,r.restart(),r.emit("camera",{byUser:!1}))}}function Ql(r,e,t){let n=document.createElement("canvas");addEventListener("beforeprint",()=>{Object.assign(n,{width:r.width,height:r.height}),e(),n.getContext("2d").drawImage(r,0,0),r.after(n)},{signal:t}),addEventListener("afterprint",()=>n.remove(),{signal:t})}var ec=[[1,3],[-3,1],[3,-1],[-1,-3]].map(r=>r.map(e=>e/8)),nm={kind:"sun",direction:[0,1,0],colour:[0,0,0]},Jr=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{engine:e,canvas:t,orbit:n}),Object.assign(this,{lights:[],firstLights:null,sky:null,shownCamera:null,ground:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,generation:0,msPerPixel:.005,shown:null,rowsAhead:0,ready:!1,stopped:!1,moving:!1,isHeld:!1,resting:!1,backdrop:null,coarsest:16,coarsestSeen:()=>1/0,stats:{ms:0,rounds:0}}),this.wake=null}restart(e=!1,t=16){Object.assign(this,{moving:e,coarsest:t,isHeld:!1}),Object.assign(this.stats,{rounds:0,scale:0,isSharp:!1}),this.generation+=1,this.wake?.()}hold(){Object.assign(this,{moving:!0,isHeld:!0}),this.generation+=1}start(){this.ready=!0,this.restart(),this.running??=this._run()}pause(){this.ready=!1,this.generation+=1}rest(e){this.resting=e,e||this.rouse?.()}stop(){return this.stopped=!0,this.rest(!1),this.pause(),this.wake?.(),this.running}async pictured(){for(;!this.shown;)await this._nextPicture()}async converged(e=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=e);)await this._nextPicture()}_nextPicture(){return new Promise(e=>this.addEventListener("shown",e,{once:!0}))}show(){if(!this.shown)return;let{rounds:e,firstLook:t}=this.shown,n=this.denoise&&e<12&&!t;this.engine.show({rounds:e,firstLook:t,rowsAhead:this.rowsAhead,exposure:2**this.exposure,backdrop:this.backdrop?[...this.backdrop,1]:[0,0,0,0],filmic:this.view==="filmic",spread:n?.4/Math.sqrt(e):0,camera:this.shownCamera,sky:this.sky})}async _run(){for(;!this.stopped;){let e=this.generation;try{this.ready&&await this._picture(e)}catch(t){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:t})),this.ready=!1}e===this.generation&&!this.stopped&&await new Promise(t=>{this.wake=t})}}async _picture(e){if(this.isFleeting=this.moving,!this.isHeld)for(let t of this._scales()){let n=t===1&&!this.moving?this.rounds:+!this.firstLights;if(!await this._stage(e,t,n)||this.moving)return}}_scales(){let e=this.canvas.width*this.canvas.height*Math.max(1,(this.firstLights??this.lights).length),t=Math.min(this.coarsest,this.coarsestSeen()),n=1;for(;n<t&&e*this.msPerPixel/n**2>110;)n*=2;let s=[n];for(;n>1;)s.push(n/=n>4?4:2);return s}async _stage(e,t,n){let{engine:s,canvas:i}=this,a=Math.ceil(i.width/t),o=Math.ceil(i.height/t);this.shown=null,s.resize(a,o);let l={...this.orbit.camera(a,o),jitter:this.jitter},{firstLights:u}=this;if(u){if(!await this._look(e,{...l,jitter:0},t))return!1}else if(!this.hasShown&&this.coarsestSeen()>4){if(!await this._round(e,l,0,this.lights.slice(0,1)))return!1;this._present(l,1,t,0,s.target,!1)}for(let f=0;f<n;f++){let p=performance.now();if(!await this._round(e,l,f,this.lights))return!1;let m=performance.now()-p;this._present(l,f+1,t,u?rm(f+1):0),this._measure(m,a*o,this.lights.length),t===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*m:m)}return!0}_round(e,t,n,s){return this._bands(e,s.length,(i,a)=>{this._band(t,n,s,i,a),this.shown?.rounds===n&&(this.rowsAhead=a)})}async _look(e,t,n){let{engine:s,canvas:i,firstLights:a,moving:o,stats:l}=this,{target:u}=s,f=performance.now(),p={width:i.width,height:i.height},m=n===1||n>4||o,g=[[t,u],[{...this.orbit.camera(p.width,p.height),jitter:0},p]];if(!await this._bands(e,a.length,(w,A)=>{this._band(t,0,a,w,A),s.remember()}))return!1;for(let[w,A]of m?g.slice(0,1):g.slice(Number(l.isSharp))){if(!await this._edges(e,w,A))return!1;this._present(w,0,n,1,A),A===u&&this._measure(performance.now()-f,u.width*u.height,a.length)}return!0}_edges(e,t,n){let{engine:s}=this;return this._bands(e,1,(i,a)=>ec.forEach((o,l)=>{s.trace({...t,shift:o},0,i,a,n.width),s.smoothEdges(ec.length,l===0,n)}),n)}async _bands(e,t,n,{width:s,height:i}=this.engine.target){let{engine:a}=this,o=this.msPerPixel*s*Math.max(1,t),l=Math.max(1,Math.min(i,Math.floor(120/o),Math.floor(a.bandPixels/s)));for(let u=0;u<i;u+=l)if(this.resting&&await new Promise(p=>{this.rouse=p}),n(u,Math.min(i,u+l)),await a.done(),(this.isFleeting?!this.ready||!this.moving:e!==this.generation)||this.stopped||a.lost)return!1;return!0}_band(e,t,n,s,i){let{engine:a}=this;a.trace(e,t,s,i),(n.length?n:[nm]).forEach((l,u)=>a.light({...l,ground:this.ground},{isFirst:t===0&&u===0,countsCoverage:u===0,number:u})),a.emits&&a.emission()}_present(e,t,n,s,i=this.engine.target,a=!0){Object.assign(this,{shown:{rounds:t,firstLook:s},shownCamera:{...e,...i},rowsAhead:0}),this.show(),this.hasShown||performance.mark("picture"),this.hasShown=!0,Object.assign(this.stats,{rounds:t,scale:n,isSharp:a&&n<=4}),this.dispatchEvent(new Event("shown"))}_measure(e,t,n){let s=e/(t*Math.max(1,n));this.msPerPixel=t<4096?Math.min(this.msPerPixel*4,s):.5*(this.msPerPixel+s)}},rm=r=>Math.max(0,1-r/64)/(1+r/8);var sm=22e5,im=4,am=6e4,Qr=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{place:e,notices:t,settings:n,losses:0,lives:0,isResting:!1,canvas:null,size:{width:1,height:1}}),this.look={backdrop:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,coarsestSeen:()=>1/0},new ResizeObserver(()=>this.resize()).observe(e)}_followScreen(){this.following=new AbortController;let e=()=>{this.following.abort(),this.resize(),this._followScreen()};matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change",e,{signal:this.following.signal})}begin(){return this.replace()}end(){this.lives+=1,this.begun=Promise.resolve(!1),this.following?.abort(),this.living?.abort(),this.viewer?.stop(),this.engine?.close(),Object.assign(this,{viewer:null,engine:null})}replace(){this.end(),this.since=performance.now();let e=this._begin().then(()=>e===this.begun?!!this.engine:this.begun,t=>e!==this.begun?this.begun:(this._giveUp(t),!1));return this.begun=e}async _begin(){let e=this.lives,t=document.createElement("canvas"),n=await Xr.open(t);if(e!==this.lives)return n.close();this.engine=n,this.resize(),this.mount(t),n.onlost=s=>this._lost(n,s),this.viewer=Object.assign(new Jr(n,t,this.orbit),this.look,{resting:this.isResting}),this.viewer.addEventListener("shown",()=>this.pictured()),this.viewer.addEventListener("failed",({error:s})=>this._lost(n,tc(s))),performance.mark("engine"),Ql(t,()=>this.viewer.show(),this.living.signal),this.emit("engine"),this._followScreen(),await this.restore(n)}mount(e){this.living?.abort(),this.canvas?.remove(),Object.assign(this,{canvas:e,living:new AbortController}),Object.assign(e,this.size),this.place.append(e),El(e,Jl(this),t=>Xl(this,t),this.living.signal),this.emit("canvas")}_giveUp(e){this.end(),this.canvas?.remove(),this.canvas=null,this.failed(e,"engine")}rest(e){this.isResting=e,this.viewer?.rest(e)}resize(){let{clientWidth:e,clientHeight:t}=this.place,n=this.settings.pixelRatio??Math.min(devicePixelRatio,2),s=Math.min(n,Math.sqrt(sm/Math.max(1,e*t))),i=Math.max(1,Math.round(e*s)),a=Math.max(1,Math.round(t*s));this.size.width===i&&this.size.height===a||(this.size={width:i,height:a},this.canvas&&Object.assign(this.canvas,this.size),this.resized(),this.viewer?.restart())}get wgsl(){return{compose:Vr,sharedFiles:At,rayKernels:Wr}}reader(){return this.viewer.pause(),new Br(this.engine)}async screenshot(e="image/png",t=void 0){return await this.viewer.pictured(),this.viewer.show(),new Promise(n=>this.canvas.toBlob(n,e,t))}async _lost(e,t){if(e===this.engine){if(this.losses=performance.now()-this.since>am?1:this.losses+1,this.losses>=im)return this._giveUp(new $(`${t}, ${this.losses} times`));this.notices.say(`${t}; starting again`,!0,"engine"),await this.replace()&&this.notices.say(null,!1,"engine")}}emit(e,t){this.dispatchEvent(Object.assign(new Event(e),t))}failed(e,t){nc(e)||console.error(e),this.notices.say(tc(e),!1,t),this.failures=(this.failures??0)+1,this.emit("failed",{error:e,about:t})}},nc=r=>r instanceof wn||r instanceof $,tc=r=>nc(r)?r.message:`this did not work: ${r.message??r}`;var Ge=[64,128],sc=[64,128],om=512,lm=4,rc=8,cm=Math.cos(15*Math.PI/180),um=200,Ht=Ge[0]*Ge[1],ic=r=>lt(fm(r));function*fm(r){let e=hm(r),t=pm(e);yield;let{flux:n,sums:s,directions:i}=mm(e.rgb,t);yield;let{excess:a,share:o}=dm(n),l=gm(a),u=new Uint8Array(Ht);for(let m of l)for(let g of m)u[g]=1;yield;let{radiance:f,up:p}=wm(e.rgb,t,m=>u[m]?1-o[m]:1);return{lights:l.map(m=>ym(m,a,g=>s[g]*o[Math.floor(g/3)],i)),up:p,rest:yield*ql(f,sc)}}function hm({rgb:r,width:e,height:t}){let n=Math.ceil(om/e);if(n<=1)return{rgb:r,width:e,height:t};let s=n*e,i=n*t,a=new Float32Array(3*s*i);for(let o=0;o<i;o++){let l=(o+.5)/n-.5,u=Math.floor(l),f=l-u,p=[Math.max(u,0),Math.min(u+1,t-1)];for(let m=0;m<s;m++){let g=(m+.5)/n-.5,_=Math.floor(g),w=g-_,A=[(_+e)%e,(_+1)%e];for(let T=0;T<3;T++){let F=(le,we)=>r[3*(p[le]*e+A[we])+T],G=F(0,0)+w*(F(0,1)-F(0,0)),te=F(1,0)+w*(F(1,1)-F(1,0));a[3*(o*s+m)+T]=G+f*(te-G)}}}return{rgb:a,width:s,height:i}}function pm({width:r,height:e}){let t=new Float64Array(e),n=new Int32Array(e);for(let s=0;s<e;s++){let i=Math.PI*(s+.5)/e;t[s]=2*Math.PI/r*(Math.cos(Math.PI*s/e)-Math.cos(Math.PI*(s+1)/e)),n[s]=Math.min(Ge[0]-1,Math.floor((1-Math.cos(i))/2*Ge[0]))}return{width:r,height:e,solid:t,rows:n}}var ac=({rows:r,width:e},t,n)=>r[t]*Ge[1]+Math.floor(n/e*Ge[1]);function mm(r,e){let t=new Float64Array(3*Ht),n=new Float64Array(Ht),s=new Float64Array(3*Ht);for(let a=0,o=0;a<e.height;a++){let l=Math.PI*(a+.5)/e.height,u=e.solid[a],f=Math.sin(l),p=Math.cos(l);for(let m=0;m<e.width;m++,o+=3){let g=ac(e,a,m),_=2*Math.PI*(m+.5)/e.width-Math.PI;n[g]+=u;for(let A=0;A<3;A++)t[3*g+A]+=r[o+A]*u;let w=$e(r,o/3)*u;s[3*g]+=w*f*Math.sin(_),s[3*g+1]+=w*p,s[3*g+2]-=w*f*Math.cos(_)}}return{flux:t.map((a,o)=>a/n[Math.floor(o/3)]*(4*Math.PI/Ht)),sums:t,directions:s}}var $e=(r,e)=>(r[3*e]+r[3*e+1]+r[3*e+2])/3;function dm(r){let e=lm*r.reduce((n,s)=>n+s,0)/r.length,t=Float64Array.from({length:Ht},(n,s)=>Math.max(0,1-e/Math.max($e(r,s),1e-30)));return{share:t,excess:r.map((n,s)=>n*t[Math.floor(s/3)])}}function Un(r){let e=1-2*(Math.floor(r/Ge[1])+.5)/Ge[0],t=Math.sqrt(1-e*e),n=2*Math.PI*(r%Ge[1]+.5)/Ge[1]-Math.PI;return[t*Math.sin(n),e,-t*Math.cos(n)]}function Fi(r,e){let t=[0,0,0],n=0;for(let i of r){let a=$e(e,i);n+=a,Un(i).forEach((o,l)=>{t[l]+=a*o})}let s=Math.hypot(...t)||1;return{flux:n,size:s,direction:t.map(i=>i/s)}}function gm(r){let e=[];for(let s=0;s<Ht;s++)$e(r,s)>0&&e.push(s);e.sort((s,i)=>$e(r,i)-$e(r,s));let t=[],n=s=>e.filter(i=>X(Un(i),s)>cm);for(;e.length&&t.length<rc;){let i=e.slice(0,um).map(o=>Fi(n(Un(o)),r)).reduce((o,l)=>l.flux>o.flux?l:o),a=new Set(n(i.direction));t.push([...a]),e=e.filter(o=>!a.has(o))}for(;t.length&&t.length<rc&&_m(t,r););return t}function _m(r,e){let t=p=>{let{flux:m,size:g}=Fi(p,e);return m-g},n=r.reduce((p,m)=>t(m)>t(p)?m:p),{direction:s}=Fi(n,e),i=vm(n,e,s),a=n.map(p=>X(Un(p),i)),o=0,l=0;n.forEach((p,m)=>{o+=$e(e,p)*a[m],l+=$e(e,p)});let[u,f]=[!0,!1].map(p=>n.filter((m,g)=>a[g]*l>o===p));return!u.length||!f.length?!1:(r.splice(r.indexOf(n),1,u,f),!0)}function vm(r,e,t){let n=[[0,0,0],[0,0,0],[0,0,0]];for(let i of r){let a=Un(i).map((l,u)=>l-t[u]),o=$e(e,i);for(let l=0;l<3;l++)for(let u=0;u<3;u++)n[l][u]+=o*a[l]*a[u]}let s=[.6,.5,.62];for(let i=0;i<60;i++){let a=n.map(l=>X(l,s)),o=Math.hypot(...a);if(!o)break;s=a.map(l=>l/o)}return s}function ym(r,e,t,n){let s=[0,1,2].map(o=>r.reduce((l,u)=>l+t(3*u+o),0)),i=[0,0,0];for(let o of r){let l=n.subarray(3*o,3*o+3),u=$e(e,o)/Math.hypot(...l);l.forEach((f,p)=>{i[p]+=u*f})}let a=Math.hypot(...i);return{direction:i.map(o=>o/a),colour:s}}function wm(r,e,t){let[n,s]=sc,i=new Float64Array(3*n*s),a=new Float64Array(n*s),o=[0,0,0];for(let l=0,u=0;l<e.height;l++){let f=Math.max(0,Math.cos(Math.PI*(l+.5)/e.height)),p=e.solid[l];for(let m=0;m<e.width;m++,u+=3){let g=Math.floor(l/e.height*n)*s+Math.floor(m/e.width*s),_=p*t(ac(e,l,m));a[g]+=p;for(let w=0;w<3;w++)i[3*g+w]+=_*r[u+w],o[w]+=_*f*r[u+w]}}return{radiance:i.map((l,u)=>l/a[Math.floor(u/3)]),up:o}}var bm={studio:["Studio",Ca],white:["White from all sides",()=>br([1,1,1])]},xm=[1.06,1,.9],es=Math.PI/180,ts=class{constructor(){this.images=new Map(Object.entries(bm).map(([e,[t,n]])=>[e,{label:t,make:n}])),this.choice="studio",this.turntable=0,this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:[],imageTurn:0})}add(e,t){let n=`image-${this.images.size}`;return this.images.set(n,{label:e,make:()=>t}),n}tables(){let e=this.images.get(this.choice);return e.tables??=Fa(e.make()),e.tables}get isPrepared(){return!(this.strength>0)||!!this.images.get(this.choice).first}async prepare(){let e=this.images.get(this.choice);e.first??=await(e.finding??=ic(e.make()))}firstLights(){if(!(this.strength>0))return null;let{lights:e,rest:t,up:n}=this.images.get(this.choice).first,s=this._turn(),i=o=>o.map(l=>l*this.strength),a=e.map(({direction:o,colour:l})=>({kind:"sun",direction:oc(o,s),colour:i(l)}));return[...this._suns(),...a,{kind:"mirror",colour:i(n),radiance:i([1,1,1]),turn:s,rest:t}]}lights(){let e=this._suns(),t=[0,0,0];for(let{direction:n,colour:s}of e)s.forEach((i,a)=>{t[a]+=i*Math.max(0,n[1])});if(this.strength>0){let n=[this.strength,this.strength,this.strength],s=this._turn();e.push({kind:"environment",colour:n,angle:s},{kind:"aroundPoint",colour:n,angle:s}),this.tables().up.forEach((i,a)=>{t[a]+=i*this.strength})}return{lights:e,irradiance:t}}_turn(){return(this.rotation+this.turntable+this.imageTurn)*es}_suns(){let e=(this.rotation+this.turntable)*es;return(this.suns??[this._sun()]).filter(({irradiance:t})=>t.some(n=>n>0)).map(({direction:t,irradiance:n})=>({kind:"sun",direction:oc(t,e),colour:n}))}_sun(){let e=this.sunHeight*es,t=this.sunAzimuth*es;return{direction:[Math.cos(e)*Math.sin(t),Math.sin(e),Math.cos(e)*Math.cos(t)],irradiance:xm.map(n=>n*this.sun)}}};function oc([r,e,t],n){let s=Math.cos(n),i=Math.sin(n),a=Math.hypot(r,e,t);return[(s*r+i*t)/a,e/a,(s*t-i*r)/a]}async function lc(r,e){let{parts:t,extensions:n={}}=r.manifest,s=n.RNA_standin_textures?.parts??[],i=n.RNA_standin?.parts,a=!t.every((m,g)=>Am(m,s[g])&&!r.tier().parts[g].emission);if(a&&!(e&&i))return null;let o=({normalMaps:m=[],transmittance:g=[]})=>[...m,...g].map(({texture:_})=>_),l=await r.read(t.flatMap((m,g)=>[m.geometry,...o(m),...Object.values(s[g]??{})])),u=t.map(({kind:m,geometry:g})=>m==="fiber"?Sm(Or(l.get(g),g)):{mesh:Nr(l.get(g),g)}),f=await r.prints(u);return{parts:await Promise.all(u.map(async(m,g)=>{let _=await Em(s[g],l),{baseColor:w=[.5,.5,.5],roughness:A=1,metallic:T=0}=i?.[g]??{},F=_?{factor:[1,1,1],image:_.baseColor}:{factor:w},G=(t[g].normalMaps??[]).map(({triangles:ne,texture:Gt})=>({triangles:ne,normals:Fr(l.get(Gt),Gt)})),te=(t[g].transmittance??[]).map(ne=>({triangles:ne.triangles,holes:{cutoff:.5,...ne,...Pr(l.get(ne.texture),ne,ne.texture)}})),le=f[g].map(ne=>({factor:[1,1,1],...ne})),we=Rm(m.mesh.indices.length/3,[{...F,normals:_?.normal},...le,...G,...te]);return{...m,roughness:A,metallic:T,metallicRoughness:_?.metallicRoughness??null,ranges:we}})),box:km(u),isPlain:a}}var Am=({kind:r,baseColor:e},t)=>r==="surface"&&!!(e||t);async function Em(r,e){if(!r)return null;let t=async([n,s])=>[n,await createImageBitmap(new Blob([e.get(s)]),{colorSpaceConversion:"none",premultiplyAlpha:"none"})];return Object.fromEntries(await Promise.all(Object.entries(r).map(t)))}function Rm(r,e){let t=e.flatMap(({triangles:[s,i]=[0,r]})=>[s,s+i]),n=[...new Set(t)].sort((s,i)=>s-i);return n.slice(1).map((s,i)=>{let a=n[i],o=({triangles:[l,u]=[0,r]})=>l<=a&&a<l+u;return{...Object.assign({},...e.filter(o)),triangles:[a,s-a]}})}function Sm({points:r,radii:e,offsets:t}){let n=e.length,s=new Float32Array(6*n),i=new Float32Array(6*n),a=new Float32Array(4*n),o=[];for(let l=0;l+1<t.length;l++){let u=t[l],f=t[l+1]-1;for(let p=u;p<=f;p++){let m=3*Math.max(u,p-1),g=3*Math.min(f,p+1);for(let _=0;_<2;_++){for(let w=0;w<3;w++)s[6*p+3*_+w]=r[3*p+w],i[6*p+3*_+w]=r[g+w]-r[m+w];a[4*p+2*_]=_?e[p]:-e[p]}p<f&&o.push(2*p,2*p+1,2*p+2,2*p+2,2*p+1,2*p+3)}}return{mesh:{positions:s,normals:i,uvs:a,indices:Uint32Array.from(o)},isStrands:!0}}function km(r){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let{mesh:{positions:n}}of r)for(let s=0;s<n.length;s++)e[s%3]=Math.min(e[s%3],n[s]),t[s%3]=Math.max(t[s%3],n[s]);return{min:e,max:t}}var cc=`// glTF's metallic-roughness material under suns and an environment that is prefiltered (light/prefilter.js), in values of the screen.
precision highp float;
precision highp sampler2D;

const int MOST_SUNS = 16;
const float PI = 3.14159265;
const float COSINE_KAPPA = 3.0; // von Mises-Fisher whose mean cosine is that of a cosine lobe

uniform vec3 eye;
uniform vec3 factor;
uniform vec3 to_u;
uniform vec3 to_v;
uniform vec2 constants; // roughness, metallic
uniform bool has_image;
uniform bool has_levels; // of metallic and roughness
uniform int relief;      // of normals: 0 none, 1 glTF's, 2 the two numbers of spec/RNA.md, 4.5
uniform sampler2D image;
uniform sampler2D metallic_roughness;
uniform sampler2D normals;
uniform sampler2D holes;
uniform int hole_channels; // of transmittance; 0 without
uniform float cutoff;
uniform int suns;
uniform vec3 directions[MOST_SUNS];
uniform vec3 irradiances[MOST_SUNS];
uniform vec3 around; // radiance of the environment, in its unit
uniform vec2 turn;   // cosine and sine
uniform sampler2D environment;
uniform vec3 levels; // rows of one, number, least kappa
uniform float exposure;
uniform bool is_filmic;

in vec3 x;
in vec3 n;
in vec2 uv;
out vec4 color;

vec3 level_at(vec2 place, float level) {
    float rows = levels.x;
    return texture(environment, vec2(place.x, (level * rows + 0.5 + place.y * (rows - 1.0)) / (rows * levels.y))).rgb;
}

// Mean radiance of the environment under a von Mises-Fisher distribution about v.
vec3 mean_about(vec3 v, float kappa) {
    vec3 d = vec3(turn.x * v.x - turn.y * v.z, v.y, turn.x * v.z + turn.y * v.x);
    vec2 place = vec2(atan(d.x, -d.z) / (2.0 * PI) + 0.5, acos(clamp(d.y, -1.0, 1.0)) / PI);
    float level = clamp(2.0 * log2(kappa / levels.z), 0.0, levels.y - 1.0);
    float low = min(floor(level), levels.y - 2.0);
    return around * mix(level_at(place, low), level_at(place, low + 1.0), level - low);
}

// The mapped normal (spec/RNA.md, 4.5), its tangent from the pixel's differences.
vec3 mapped(vec3 normal) {
    vec3 e1 = dFdx(x), e2 = dFdy(x);
    vec2 d1 = dFdx(uv), d2 = dFdy(uv);
    float side = sign(d1.x * d2.y - d2.x * d1.y);
    vec3 U = (d2.y * e1 - d1.y * e2) * side, V = (d1.x * e2 - d2.x * e1) * side;
    vec3 T = U - dot(U, normal) * normal;
    if (side == 0.0 || length(T) <= 1e-6 * length(U)) return normal;
    vec3 t = normalize(T), w = cross(normal, t);
    vec3 q = texture(normals, uv).xyz * 2.0 - 1.0;
    if (relief == 2) {
        q.xy = (127.5 * q.xy + 0.5) / 127.0;
        q.z = sqrt(max(0.0, 1.0 - dot(q.xy, q.xy)));
    }
    return normalize(q.x * t + q.y * (dot(w, V) > 0.0 ? -w : w) + q.z * normal);
}

// What is reflected of light from all sides. The part beyond f0: Karis, Physically Based Shading on Mobile, 2014; here white
// metals are white.
vec3 reflected(vec3 f0, float roughness, float cosine) {
    vec3 r = roughness * vec3(-1.0, -0.0275, 0.022) + vec3(1.0, 0.0425, -0.04);
    float beyond = 1.04 * (min(r.x * r.x, exp2(-9.28 * cosine)) * r.x + r.y) + r.z;
    return f0 + (1.0 - f0) * max(beyond, 0.0);
}

// GGX with height-correlated masking, over the incoming cosine.
float ggx(vec3 m, vec3 wo, vec3 wi, float alpha) {
    float square = alpha * alpha, ci = max(dot(m, wi), 0.0), co = max(dot(m, wo), 1e-3);
    vec3 h = normalize(wo + wi), across = cross(m, h);
    float ch = dot(m, h), spread = dot(across, across) + square * ch * ch;
    float masked = ci * sqrt(square + (1.0 - square) * co * co) + co * sqrt(square + (1.0 - square) * ci * ci);
    return square / (PI * spread * spread) * 0.5 / max(masked, 1e-6);
}

// As rna_render/image/view_transform.py, which names the source.
vec3 filmic(vec3 radiance) {
    vec3 c = 1.461926 * min(radiance, vec3(1e9));
    vec3 v = vec3(dot(c, vec3(0.59719, 0.35458, 0.04823)), dot(c, vec3(0.07600, 0.90834, 0.01566)), dot(c, vec3(0.02840, 0.13383, 0.83777)));
    vec3 y = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    return vec3(dot(y, vec3(1.60475, -0.53108, -0.07367)), dot(y, vec3(-0.10208, 1.10813, -0.00605)), dot(y, vec3(-0.00327, -0.07276, 1.07602)));
}

void main() {
    // What lets more light pass is taken to be open.
    vec3 passed = texture(holes, uv).rgb;
    if (hole_channels > 0 && (hole_channels == 1 ? passed.r : dot(passed, vec3(1.0 / 3.0))) > cutoff) discard;
    vec3 wo = normalize(eye - x), m = normalize(n);
    if (dot(m, wo) < 0.0) m = -m;
    vec3 base = factor;
    vec2 looks = constants;
    if (has_image) base *= texture(image, vec2(dot(to_u, vec3(uv, 1.0)), dot(to_v, vec3(uv, 1.0)))).rgb;
    if (has_levels) looks = texture(metallic_roughness, uv).gb;
    if (relief > 0) m = mapped(m);
    float roughness = max(looks.x, 0.03), metallic = looks.y, alpha = roughness * roughness, co = max(dot(m, wo), 1e-3);
    vec3 f0 = mix(vec3(0.04), base, metallic), albedo = (1.0 - metallic) * base * (1.0 - reflected(vec3(0.04), roughness, co));
    vec3 light = albedo * mean_about(m, COSINE_KAPPA);
    // Of the lobe about the mirrored direction: Wang et al., All-Frequency Rendering of Dynamic, Spatially-Varying Reflectance, 2009.
    light += reflected(f0, roughness, co) * mean_about(reflect(-wo, m), 0.5 / (alpha * alpha));
    for (int k = 0; k < suns; k++) {
        vec3 wi = directions[k];
        float fresnel = pow(1.0 - max(dot(wo, normalize(wo + wi)), 0.0), 5.0);
        light += (albedo / PI + (f0 + (1.0 - f0) * fresnel) * ggx(m, wo, wi, alpha)) * irradiances[k] * max(dot(m, wi), 0.0);
    }
    light *= exposure;
    light = clamp(is_filmic ? filmic(light) : light, 0.0, 1.0);
    color = vec4(mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light)), 1.0);
}
`;var Im=16,Ci={image:0,metallic_roughness:1,normals:2,environment:3,holes:4},Tm=`#version 300 es
uniform mat4 seen;
uniform vec3 eye;
uniform vec3 middle;
uniform bool is_strands;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 place;
out vec3 x;
out vec3 n;
out vec2 uv;
void main() {
    x = position;
    n = normal;
    uv = place;
    if (is_strands) { // across the view, and lit as what they cover together: outwards
        vec3 t = normalize(normal), across = cross(t, eye - position), outwards = position - middle;
        x += place.x * across / max(length(across), 1e-20);
        n = outwards - dot(outwards, t) * t;
    }
    gl_Position = seen * vec4(x, 1.0);
}`,ns=class r{static open(e,t){let n=e.getContext("webgl2",{antialias:!0,preserveDrawingBuffer:!0});return n&&new r(n,t)}constructor(e,{parts:t,box:{min:n,max:s}}){Object.assign(this,{gl:e,middle:n.map((a,o)=>(a+s[o])/2),radius:Math.hypot(...s.map((a,o)=>a-n[o]))/2||1}),this.program=Om(e,Tm,`#version 300 es
${cc}`),e.useProgram(this.program),this.at=Mm(e,this.program),this.textures=new Map;let i=this._texture({width:1,height:1,pixels:new Uint8Array(4)},{});for(let[a,o]of Object.entries(Ci))e.uniform1i(this.at[a],o),this._bind(a,i);this.parts=t.map(a=>this._part(a)),e.uniform3fv(this.at.middle,this.middle),e.enable(e.DEPTH_TEST)}draw({camera:e,lights:t,exposure:n,isFilmic:s}){let{gl:i,at:a}=this,{width:o,height:l}=i.canvas;i.viewport(0,0,o,l),i.clear(i.COLOR_BUFFER_BIT|i.DEPTH_BUFFER_BIT),i.uniformMatrix4fv(a.seen,!1,this._seen(e,o,l)),i.uniform3fv(a.eye,e.position),i.uniform1f(a.exposure,n),i.uniform1i(a.is_filmic,Number(s)),this._light(t);for(let u of this.parts)this._draw(u)}close(){this.gl.getExtension("WEBGL_lose_context")?.loseContext()}_seen({position:e,corner:t,stepX:n,stepY:s},i,a){let o=n.map(T=>T*i),l=s.map(T=>T*a),u=t.map((T,F)=>T+(o[F]+l[F])/2),f=this.middle.map((T,F)=>T-e[F]),p=Math.max(X(f,u)+1.01*this.radius,.001*this.radius),m=Math.max(X(f,u)-1.01*this.radius,.001*p),g=(T,F)=>T.map(G=>F*G/X(T,T)),_=(p+m)/(p-m),w=[g(o,2),g(l,-2),u.map(T=>_*T),u],A=w.map((T,F)=>-X(T,e)-(F===2?2*p*m/(p-m):0));return[0,1,2].flatMap(T=>w.map(F=>F[T])).concat(A)}_light(e){let{gl:t,at:n}=this,s=e.filter(({kind:a})=>a==="sun").slice(0,Im),i=e.find(({kind:a})=>a==="mirror");t.uniform1i(n.suns,s.length),s.length&&(t.uniform3fv(n.directions,s.flatMap(({direction:a})=>a)),t.uniform3fv(n.irradiances,s.flatMap(({colour:a})=>a))),t.uniform3fv(n.around,i?i.radiance.map(a=>a*i.rest.unit):[0,0,0]),t.uniform2f(n.turn,Math.cos(i?.turn??0),Math.sin(i?.turn??0)),i&&i.rest!==this.rest&&this._setEnvironment(i.rest)}_setEnvironment(e){let{gl:t,at:n}=this,{texels:s,width:i,height:a,levels:o}=e;this.rest=e,t.activeTexture(t.TEXTURE0+Ci.environment),t.bindTexture(t.TEXTURE_2D,this.environment??=t.createTexture()),t.texImage2D(t.TEXTURE_2D,0,t.RGBA16F,i,a*o,0,t.RGBA,t.HALF_FLOAT,s);for(let l of["MIN","MAG"])t.texParameteri(t.TEXTURE_2D,t[`TEXTURE_${l}_FILTER`],t.LINEAR);t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.CLAMP_TO_EDGE),t.uniform3f(n.levels,a,o,.25)}_part({mesh:{positions:e,normals:t,uvs:n,indices:s},isStrands:i=!1,roughness:a,metallic:o,metallicRoughness:l,ranges:u}){let{gl:f}=this,p=f.createVertexArray();f.bindVertexArray(p),[[e,3],[t,3],[n,2]].forEach(([_,w],A)=>{_&&(f.bindBuffer(f.ARRAY_BUFFER,f.createBuffer()),f.bufferData(f.ARRAY_BUFFER,_,f.STATIC_DRAW),f.enableVertexAttribArray(A),f.vertexAttribPointer(A,w,f.FLOAT,!1,0,0))}),f.bindBuffer(f.ELEMENT_ARRAY_BUFFER,f.createBuffer()),f.bufferData(f.ELEMENT_ARRAY_BUFFER,s,f.STATIC_DRAW);let m=(_,w)=>_&&this._texture(_,w),g={colorSpace:"linear"};return{array:p,isStrands:i,roughness:a,metallic:o,levels:m(l,g),ranges:u.map(_=>({..._,texture:m(_.image,_),map:m(_.normals,g),open:m(_.holes,g),relief:_.normals?_.normals.values?2:1:0}))}}_texture(e,{colorSpace:t="srgb",wrap:n=["repeat","repeat"]}){let{gl:s}=this,i=JSON.stringify([t,n]),a=this.textures.get(e)??new Map;if(this.textures.set(e,a),a.has(i))return a.get(i);let o=s.createTexture(),l=t==="srgb"?s.SRGB8_ALPHA8:s.RGBA8;a.set(i,o),s.activeTexture(s.TEXTURE0),s.bindTexture(s.TEXTURE_2D,o);let{width:u,height:f}=e,p=(g,_,w)=>s.texImage2D(s.TEXTURE_2D,0,g,u,f,0,_,s.UNSIGNED_BYTE,w);s.pixelStorei(s.UNPACK_ALIGNMENT,1),e.pixels?p(l,s.RGBA,e.pixels):e.values?p(...[[s.R8,s.RED],[s.RG8,s.RG],[s.RGB8,s.RGB]][e.channels-1],e.values):s.texImage2D(s.TEXTURE_2D,0,l,s.RGBA,s.UNSIGNED_BYTE,e),s.generateMipmap(s.TEXTURE_2D),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MIN_FILTER,s.LINEAR_MIPMAP_LINEAR);let m={repeat:s.REPEAT,clamp:s.CLAMP_TO_EDGE,mirror:s.MIRRORED_REPEAT};return n.forEach((g,_)=>s.texParameteri(s.TEXTURE_2D,[s.TEXTURE_WRAP_S,s.TEXTURE_WRAP_T][_],m[g])),o}_draw({array:e,isStrands:t,roughness:n,metallic:s,levels:i,ranges:a}){let{gl:o,at:l}=this;o.bindVertexArray(e),o.uniform1i(l.is_strands,Number(t)),o.uniform2f(l.constants,n,s),o.uniform1i(l.has_levels,+!!i),i&&this._bind("metallic_roughness",i);for(let{triangles:[u,f],factor:p=[1,1,1],texture:m,map:g,open:_,holes:w,relief:A,transform:T=[1,0,0,0,1,0]}of a)o.uniform1i(l.relief,A),g&&this._bind("normals",g),o.uniform1i(l.hole_channels,w?.channels??0),_&&(this._bind("holes",_),o.uniform1f(l.cutoff,w.cutoff)),o.uniform3fv(l.factor,p),o.uniform1i(l.has_image,+!!m),m&&this._bind("image",m),o.uniform3fv(l.to_u,T.slice(0,3)),o.uniform3fv(l.to_v,T.slice(3)),o.drawElements(o.TRIANGLES,3*f,o.UNSIGNED_INT,12*u)}_bind(e,t){this.gl.activeTexture(this.gl.TEXTURE0+Ci[e]),this.gl.bindTexture(this.gl.TEXTURE_2D,t)}};function Om(r,e,t){let n=r.createProgram();for(let[s,i]of[[r.VERTEX_SHADER,e],[r.FRAGMENT_SHADER,t]]){let a=r.createShader(s);r.shaderSource(a,i),r.compileShader(a),r.attachShader(n,a)}if(r.linkProgram(n),!r.getProgramParameter(n,r.LINK_STATUS))throw new Error(`the stand-in's shaders do not compile: ${r.getProgramInfoLog(n)}`);return n}function Mm(r,e){let t=Array.from({length:r.getProgramParameter(e,r.ACTIVE_UNIFORMS)},(n,s)=>r.getActiveUniform(e,s).name);return Object.fromEntries(t.map(n=>[n.replace("[0]",""),r.getUniformLocation(e,n)]))}var Lm=400,Pm=["glass","maps","tint","skybox"],rs=class{#e;constructor(e){this.#e=e,Object.assign(this,{opened:null,isShown:!1,isPlain:!1,renderer:null,shownCamera:null})}async show(e,t=!1){let n=this.#e,s=this.request={},i=()=>s===this.request&&!n.isWhole;this.opened=e;try{let a=Pm.some(o=>n.settings[o])?null:await lc(e,t);if(!a&&i()&&this.end(),!a)return;await n.lit,await n.lighting.prepare(),i()&&this._begin(a)}catch(a){console.warn(`rna-viewer: no stand-in: ${a.message}`)}}again(e=!1){if(this.opened&&!this.isShown)return this.show(this.opened,e)}_begin(e){let t=this.#e,n=Object.assign(document.createElement("canvas"),t.size);this.end(),this.renderer=ns.open(n,e),this.renderer&&(this.canvas=n,n.addEventListener("webglcontextlost",()=>n===this.canvas&&this.end()),n.setAttribute("aria-hidden","true"),t.place.prepend(n),t.place.classList.add("standing"),t.canvas||t.mount(document.createElement("canvas")),t.arrive(this.opened,e.box),Object.assign(this,{isShown:!0,isPlain:e.isPlain}),this._draw(),performance.mark("stand-in"),t.emit("stand-in"))}resize(){this.renderer&&(Object.assign(this.canvas,this.#e.size),this._draw())}draw(){!this.renderer||this.isRequested||this.#e.isResting||(this.isRequested=!0,requestAnimationFrame(()=>{this.isRequested=!1,this._draw()}))}_draw(){let{renderer:e,canvas:t}=this,n=this.#e,{lighting:s,look:i}=n;if(!e)return;if(!s.isPrepared)return void s.prepare().then(()=>this.draw());let a=n.orbit.camera(t.width,t.height),o=s.firstLights()??s.lights().lights;e.draw({camera:a,lights:o,exposure:2**i.exposure,isFilmic:i.view==="filmic"}),this.shownCamera={...a,width:t.width,height:t.height},this.isShown&&n.emit("shown")}leave(){this.isShown&&(this._hide(),this.leaving=setTimeout(()=>this.end(),Lm))}_hide(){this.isShown=!1,this.#e.place.classList.remove("standing"),this.#e.emit("stand-in")}end(){clearTimeout(this.leaving);let{canvas:e,renderer:t,isShown:n}=this;Object.assign(this,{canvas:null,renderer:null,isPlain:!1,shownCamera:null}),e?.remove(),t?.close(),n&&this._hide()}forget(){Object.assign(this,{opened:null,request:null}),this.end()}};var uc=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),Fm=[[.59719,.35458,.04823],[.076,.90834,.01566],[.0284,.13383,.83777]],Cm=[[1.60475,-.53108,-.07367],[-.10208,1.10813,-.00605],[-.00327,-.07276,1.07602]];function zm(r){let e=Fm.map(t=>{let n=1.461926*uc(t,r);return(n*(n+.0245786)-90537e-9)/(n*(.983729*n+.432951)+.238081)});return Cm.map(t=>uc(t,e))}function fc(r){let e=[...r];for(let t=0;t<60;t++){let n=zm(e);e=e.map((s,i)=>s*Math.min(2,Math.max(.5,r[i]/Math.max(n[i],1e-6))))}return e}var Um=50,is=class extends Qr{constructor(e,t,n){super(e,t,n),Object.assign(this,{orbit:new or,lighting:new ts,labels:{},ground:!1,scene:null,isTouched:!1,isStill:!1}),this.glide=new zr(this),this.standIn=new rs(this),Object.assign(this,{opened:null,shown:null,loading:null,lit:Promise.resolve(),placing:Promise.resolve()}),Object.assign(this,{isWhole:!1,arrived:null})}close(){this.loading?.abort(),this.requestedScene=null,this.end(),this.standIn.end()}replace(){this.isWhole=!1;let e=super.replace();return this.standIn.again(),e}_giveUp(e){this.isWhole=!1,super._giveUp(e),this.standIn.isShown?this.mount(document.createElement("canvas")):this.standIn.again(!this.loading)}restart(e,t){this.standIn.draw(),e&&this.standIn.isShown?this.viewer?.hold():this.viewer?.restart(e,t)}rest(e){super.rest(e),this.standIn.draw()}clear(){this.close(),this.standIn.forget(),Object.assign(this,{opened:null,shown:null,arrays:null,box:void 0,canvas:null}),this.place.replaceChildren(),this.notices.say(null,!1,"asset")}async open(e){this.loading?.abort();let t=this.loading=new AbortController,{signal:n}=t;try{this.notices.say(null,!1,"asset"),this.emit("loading"),this.notices.say(null,!0,"glass");let s=e instanceof Blob?null:this.settings.glass,i=s&&this._readGlass(s),a=(g,_)=>n.aborted||this.emit("progress",{got:g,all:_}),o=e instanceof Blob?new Wt(e,e.name):await tr.open(e,a,n,this.labels[Nt(e)]),l=Object.assign(await fn.open(o),{glass:i});n.throwIfAborted();let u=this.settings.tier,f=this._known(l,u),p=this.settings.variantName;l.variant=this._knownVariant(l,p),this.isWhole=!1;let m=this.standIn.show(l);l.environment&&this._wantsLobes(l)&&this.lit.then(()=>this.lighting.prepare()),await this.begun&&l.prefetch(f,this._wantsLobes(l)),await this._offerPoster(l),await this.begun||await m.then(()=>this.standIn.again(!0)),await this._show(l,f,!0,n),this.settings.tier!==u&&await this._show(l,this._known(l,this.settings.tier),!1,n),this.settings.variantName!==p&&await this.switchVariant(this.settings.variantName),await m}catch(s){n.aborted||this.failed(s,"asset")}finally{this.loading===t&&(this.loading=null,this.emit("ended"))}}async _readGlass(e){try{return po(new Uint8Array(await Dn(e)),this.labels[Nt(e)]??Nt(e))}catch(t){return this.notices.say(`glass: ${t.message}`,!0,"glass"),null}}_wantsLobes({glass:e}){return this.settings.firstLook!=="off"&&!e}async switchTier(e){try{this.notices.say(null,!1,"asset"),await this._show(this.opened,this._known(this.opened,e),!1)}catch(t){this.failed(t,"asset")}finally{this.emit("ended")}}async switchVariant(e){let{opened:t,arrays:n}=this,s=t.variant=this._knownVariant(t,e),i=()=>t===this.opened&&t.variant===s;try{let a=await t.prints(this.shown.parts);if(i()&&await lt(n.surfaces.reprint(a)),!i())return;n.maps={},this._printed(),await this.print(),n.variant=s}catch(a){this.failed(a,"asset")}}_knownVariant({variants:e},t){let n=t===null||e.includes(t),s=e.map(i=>JSON.stringify(i)).join(" or ")||"none: it has no variants";return this.notices.say(n?null:`variant-name: expected ${s}, found ${JSON.stringify(t)}`,!0,"variant-name"),n?t:null}_known({manifest:e},t){let n=e.tiers.map(i=>i.name),s=t===null||n.includes(t);return this.notices.say(s?null:`tier: expected ${n.join(" or ")}, found ${JSON.stringify(t)}`,!0,"tier"),s?t:null}async openScene(e){let t=this.requestedScene={};try{let n=Dm(await Dn(e),e),{radiance:s,image:i}=n.environment??{},a=o=>new URL(ro(o),new URL(e,document.baseURI)).href;if(n.asset&&(n.asset=a(n.asset)),s&&(n.environment.key=this.lighting.add("The scene's",br(s))),i){let o=this.labels[i]??i;n.environment.key=this.lighting.add(o,si(await Dn(a(i)),i))}if(t!==this.requestedScene)return!1;this.scene=n,this.reset()}catch(n){if(t!==this.requestedScene)return!1;this.failed(n,"scene")}return!0}async setMap(e,t){let{surfaces:n}=this.arrays??{},s=n?.labels??[];if(!s.includes(e))throw new Error(`expected ${s.join(" or ")||"an asset with base colour"}, found ${JSON.stringify(e)}`);await n.setImage(e,t&&await Ra(t)),this._printed()}async print(){let{arrays:e,settings:{maps:t,tint:n}}=this,s=t??{};if(!e?.hasBaseColor)return this.notices.say(t||n?"maps, tint: this asset has no base colour":null,!0,"maps");if(!(!t&&!n&&!e.maps)){e.surfaces.tint=n??[1,1,1],this._printed();try{for(let i of Object.keys(e.maps??{}).filter(a=>!(a in s)))await this.setMap(i,null);for(let[i,a]of Object.entries(s))e.maps?.[i]!==a&&await this.setMap(i,new Blob([await Dn(a)]));this.notices.say(null,!0,"maps")}catch(i){this.notices.say(`maps: ${i.message}`,!0,"maps")}e.maps=s}}_printed(){Object.assign(this.arrays,this.arrays.surfaces.arrays()),this.engine?.setSurfaces(this.arrays),this.restart()}leaveScene(){this.requestedScene=this.scene=null,this.reset()}openImage(e,t){return this.lit=this._openImage(e,t)}async _openImage(e,t){let n=this.requestedImage={};try{this.notices.say(null,!1,"light");let s=e instanceof Blob?await e.arrayBuffer():await Dn(e);if(n!==this.requestedImage)return;this.setLight({choice:this.lighting.add(this.labels[t]??t,si(s,t))})}catch(s){n===this.requestedImage&&this.failed(s,"light")}}chooseImage(e){this.requestedImage=null,this.setLight({choice:e})}setLight(e,{moving:t=!1,byUser:n=!1}={}){Object.assign(this.lighting,e),this.emit("set"),this.emit("light",{byUser:n}),this.changed(t)}changed(e=!1,t=void 0){if(!this.viewer)return this.standIn.draw();if(this.engine.hasLobes&&!this.lighting.isPrepared)return void this.lighting.prepare().then(()=>this.changed(e,t));let{lights:n,irradiance:s}=this.lighting.lights();n.some(({kind:a})=>a==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded));let i=this.settings.skybox&&n.find(({kind:a})=>a==="environment");this.viewer.sky=i?{strength:i.colour[0],angle:i.angle}:null,this.viewer.lights=n,this.viewer.firstLights=this.engine.hasLobes?this.lighting.firstLights():null,this.viewer.ground=this._ground(s),this.restart(e,t)}reset(){let{ground:e,exposure:t,view:n}=this.scene??{},{settings:s}=this;this.placeCamera(),this.placeLights(),this.ground=s.ground??e??this.ground,this.setExposure(s.exposure??t??this.look.exposure),this.setView(s.viewTransform??n??this.look.view)}placeCamera(){let{position:e,look_at:t,vertical_fov_deg:n}=this.scene?.camera??{},{settings:s}=this,i=[e?Qi(e,t,n):{},s.cameraOrbit??{},{target:s.cameraTarget,fov:s.fieldOfView}];this.isTouched=!1,this.glide.stop(),this.orbit.limits=gs(s);let{width:a,height:o}=this.size;this.orbit.place(i,this.box,a/o),this.emit("camera",{byUser:!1}),this.restart()}glideTo(e){if(!this.standIn.isShown&&(!this.viewer?.hasShown||this.isNew))return e();this.glide.to(e,this.isStill?0:this.settings.interpolationDecay??Um)}get view(){return this.glide.goal??this.orbit}limitCamera(){this.glide.stop(),this.orbit.limits=gs(this.settings),this.orbit.limit(),this.emit("camera",{byUser:!1}),this.restart()}hitAt(e,t){let{shownCamera:n,hitArrays:s}=this;return n&&s?pr(s,n.position,ca(n,e,t)):null}get shownCamera(){return this.standIn.isShown?this.standIn.shownCamera:this.viewer?.shownCamera}get hitArrays(){return this.standIn.isShown&&this.standIn.opened!==this.opened?null:this.arrays}get isWaited(){return(!!this.viewer||this.standIn.isPlain)&&this.look.coarsestSeen()<=4}placeLights(){let{suns:e,environment:t}=this.scene??{},{sun:n,lightRotation:s,environmentIntensity:i}=this.settings,{lighting:a}=this;if(a.reset(),e&&(a.suns=e),t){let{key:o,strength:l=1,rotation_deg:u=0}=t,f=!this.settings.environment&&o||a.choice;Object.assign(a,{choice:f,strength:l,imageTurn:u})}n&&Object.assign(a,n,{suns:null}),this.setLight({rotation:rr(s??0),strength:i??a.strength})}turnTable(e,t){this.orbit.turntable=-e,this.lighting.turntable=-e*180/Math.PI,this.changed(t,4)}setExposure(e,t=!0){this._setLook({exposure:e},t&&this.ground)}setView(e){this._setLook({view:e},this.ground)}setBackdrop(e){this._setLook({backdrop:e},this.ground)}setDenoise(e){this._setLook({denoise:e})}setSampling(e){this._setLook(e),this.viewer?.restart()}setGround(e){this.ground=e,this.changed()}_setLook(e,t=!1){Object.assign(this.look,e),Object.assign(this.viewer??{},e),this.emit("set"),t&&this.changed(),this.standIn.draw(),this.viewer?.show()}async _show(e,t,n,s){if(!await this.begun)return;let i=await e.load(t,{wantsLobes:this._wantsLobes(e)});i.glass=await e.glass,e.forget(),performance.mark("package"),await this.lit,await this.begun&&(this.placing=this.placing.catch(()=>{}).then(()=>this._place(e,i,n,s)),await this.placing)}async _place(e,t,n,s){if(s?.throwIfAborted(),!this.viewer||!n&&this.opened!==e)return;n&&(this.viewer.hasShown=!1),this.viewer.pause();let i=n?wr(t.parts,t.glass):this.arrays;if(!await this._upload(i,t))return;let a=await i;this.engine.hasLobes&&await this.lighting.prepare(),s?.throwIfAborted(),performance.mark("asset"),Object.assign(this,{opened:e,shown:t,arrays:a,isNew:n}),n&&await this.print(),n&&this.arrive(e,a.box);let{warnings:o}=e.manifest;o.length&&this.notices.say(o.join("; "),!0,"asset"),this.emit("package",{opened:e,shown:t}),this.viewer.stats.ms=0,this.changed(),this.viewer.start()}arrive(e,t){let n=this.arrived===e;Object.assign(this,{arrived:e,box:t}),!n&&(this.scene?this.reset():this.placeCamera())}async _upload(e,t){for(;await this.begun&&this.engine;){let{engine:n}=this;try{if(await n.setAsset(e,t),n===this.engine)return!0}catch(s){if(n===this.engine)throw s}}return!1}async restore(e){if(this.uploaded=null,!this.shown)return;this.viewer.hasShown=!0,await e.setAsset(this.arrays,this.shown),this.changed(),this.viewer?.start();let{tier:t}=this.settings;t&&t!==this.shown.name&&!this.loading&&this.switchTier(t)}resized(){this.box&&!this.isTouched&&this.placeCamera(),this.standIn.resize()}pictured(){this.emit("shown");let{isSharp:e,scale:t}=this.viewer.stats;e&&t===1&&this._whole(),!(!this.isNew||!e)&&(this.isNew=!1,this.emit("load"))}_whole(){this.arrived!==this.opened||this.standIn.opened!==this.opened||(this.isWhole=!0,this.standIn.leave())}async _offerPoster(e){try{this.emit("poster",{blob:await e.posterImage()})}catch{}}_ground(e){let{view:t,exposure:n,backdrop:s}=this.look;if(this.notices.say(this.ground&&(!s||this.settings.skybox)?"ground: expected an opaque background-color, and no skybox":null,!0,"ground"),!this.ground||!s||this.settings.skybox||!this.box)return null;let i=t==="filmic"?fc(s):s,{min:a,max:o}=this.box,l=Math.hypot(...o.map((u,f)=>u-a[f]));return{height:a[1]-1e-4*l,x:(a[0]+o[0])/2,z:(a[2]+o[2])/2,size:2*l,colour:i.map((u,f)=>e[f]>0?u/e[f]/2**n:0)}}};function Dm(r,e){try{return JSON.parse(new TextDecoder().decode(r))}catch(t){throw new $(`${e}: expected a scene.json, found ${ct(new Uint8Array(r))??t.message}`)}}async function Dn(r){let e=await fetch(r).catch(()=>null);if(!e?.ok)throw new $(`cannot load ${r}${e?`: HTTP ${e.status}`:""}`);return e.arrayBuffer()}var as=class{constructor(e){Object.assign(this,{stage:e,angle:0,isOn:!1,isTurning:!1,delay:3e3,speed:30}),e.addEventListener("shown",()=>this._next());for(let t of["load","stand-in","camera","light"])e.addEventListener(t,()=>this.wait())}wait(){clearTimeout(this.timer);let e=this.isTurning;this.isTurning=!1,this.isOn?this.timer=setTimeout(()=>this._start(),this.delay):e&&this.stage.restart()}switch(e){this.isOn=e,this.wait()}set(e){this.angle=e,this.stage.turnTable(e,this.isTurning)}_start(){this.stage.isWaited||(Object.assign(this,{isTurning:!0,last:performance.now()}),this._next())}_next(){!this.isTurning||this.isRequested||(this.isRequested=!0,requestAnimationFrame(e=>{if(this.isRequested=!1,!this.isTurning)return;let t=Math.min(.25,Math.max(0,e-this.last)/1e3);this.last=e,this.set(this.angle+t*this.speed*Math.PI/180)}))}};var Bm=6e3,hc={engine:"unavailable",asset:"failed",scene:"failed"},os=class extends nr{#e;constructor(e,t){super(e),this.#e=t,this.missed=null}say(e,t=!1,n="page"){e&&this.lines.get(n)?.text!==e&&console[t?"warn":"error"](`rna-viewer: ${e}`),super.say(e,t,n)}show(){if(this.#e.settings.messages==="whole")return this._showWhole();let e=s=>this.lines.get(s)?.calm===!1&&!(s==="engine"&&this.#e.isStoodFor),t=Object.keys(hc).find(e),n=t?hc[t]:null;n!==this.missed&&(this.missed=n,clearTimeout(this.timer),this.put(n?[Ze(this.#e,n)]:[],!0),n&&(this.timer=setTimeout(()=>{this.place.hidden=this.#e.isSeen},Bm)))}_showWhole(){clearTimeout(this.timer),this.missed=void 0,super.show()}};var Hm=["studio","white"],Gm="50% 0px",$m=500,qm=3e3,jm=/^(data-|aria-|on|dir$)|[^a-z-]/,Vm={src:"asset",environment:"light",scene:"scene"};function Wm({dataset:{rnaLabels:r}}){try{return JSON.parse(r??"{}")??{}}catch{return{}}}var ls=class{constructor(e,t,n){Object.assign(this,{x:e,y:t,z:n})}toString(){return[this.x,this.y,this.z].map(e=>`${e}m`).join(" ")}},cs=class extends(globalThis.HTMLElement??Object){static observedAttributes=[...Object.keys(at),"lang"];constructor(){super();let e=ha(this),t=n=>e.getElementById(n);this.parts={view:t("view"),poster:t("poster"),image:e.querySelector("img"),loading:t("loading"),prompt:t("prompt"),bar:t("bar"),bytes:t("bytes"),keys:t("keys"),status:t("status"),tint:t("tint")},this.settings=Object.fromEntries(Object.keys(at).map(n=>[Xt(n),null])),this.notices=new os(t("notice"),this),this.stage=new is(this.parts.view,this.notices,this.settings),this.stage.look.coarsestSeen=()=>this.stage.standIn.isShown&&!this.stage.standIn.isPlain||this._isCovered?4:1/0,this.turntable=new as(this.stage),new mr(this,t("hotspots"),this.stage),this.stillness=matchMedia("(prefers-reduced-motion: reduce)"),Object.assign(this,{loaded:!1,observer:null,isNear:!1,hasMoved:!1,isDismissed:!1,isBegun:!1,requestedSrc:null,failures:new Set}),this._listen()}connectedCallback(){this.stage.labels=Wm(this),this.observer=new IntersectionObserver(e=>this._seen(e.at(-1).isIntersecting),{rootMargin:Gm}),this.observer.observe(this),this.stillness.addEventListener("change",this.onstillness=()=>this._still()),this._takeOver(),this._still(),this._tint(),this._begin()}adoptedCallback(){Is(this.shadowRoot)}disconnectedCallback(){this.observer.disconnect(),this.stillness.removeEventListener("change",this.onstillness),queueMicrotask(()=>{this.isConnected||!this.isBegun||(this.stage.loading&&(this.requestedSrc=null),this.isBegun=!1,this.turntable.switch(!1),this.stage.close())})}attributeChangedCallback(e,t,n){if(e==="lang")return this._describe();let s=this.failures.delete(Vm[e]);if(t===n&&!s)return;["src","glass"].includes(e)&&(this.requestedSrc=null);let i=Xt(e);try{this.settings[i]=n===null?null:at[e](n),this.notices.say(null,!0,e)}catch(a){this.settings[i]=null,this.notices.say(`${e}: ${a.message}`,!0,e)}this._apply(e)}get availableTiers(){return this.stage.opened?.manifest.tiers.map(({name:e})=>e)??[]}get availableVariants(){return this.stage.opened?.variants??[]}get availableMaps(){return this.stage.arrays?.surfaces.labels??[]}setMap(e,t){return this.stage.setMap(e,t)}get turntableRotation(){return this.turntable.angle}resetTurntableRotation(e=0){this.turntable.set(e)}resetView(){this.stage.glideTo(()=>this.stage.reset())}showPoster(){this.isDismissed=!1,this.parts.poster.hidden=!1}dismissPoster(){this.isDismissed=!0,this._begin(),(this.loaded||this.stage.standIn.isShown)&&this._hidePoster()}positionAndNormalFromPoint(e,t){let{left:n,top:s,width:i,height:a}=this.parts.view.getBoundingClientRect(),o=this.stage.hitAt((e-n)/i,(t-s)/a);return o&&{position:new ls(...o.position),normal:new ls(...o.normal)}}async toBlob({mimeType:e="image/png",qualityArgument:t,converged:n=!1}={}){let{stage:s}=this;return!s.viewer||!this.loaded?null:(n&&await s.viewer.converged(),s.screenshot(e,t))}_seen(e){this.isNear=e,this.stage.rest(!e),this._tint(),this._begin()}_takeOver(){for(let t of Object.keys(at).map(Xt).filter(n=>Object.hasOwn(this,n))){let n=this[t];delete this[t],this[t]=n}let e=this.getAttributeNames();for(let t of ua(e))console.warn(`rna-viewer: ${t}`);for(let t of e.filter(n=>!(n in at)&&!fa(n)&&!jm.test(n))){let n=Ki(t,Object.keys(at));n&&console.warn(`rna-viewer has no attribute ${t}: did you mean ${n}?`)}}_apply(e){let{stage:t,settings:n}=this;e==="src"&&n.src===null&&!t.scene?.asset&&this._clear(),["src","glass"].includes(e)&&this._begin(),e==="poster"&&this._showImage(n.poster),e==="scene"&&this._openScene(),e==="environment"&&this.isBegun&&this._light(),e==="tier"&&t.opened&&!t.loading&&t.switchTier(n.tier),e==="variant-name"&&t.shown&&!t.loading&&t.switchVariant(n.variantName),e==="first-look"&&t.shown&&t.switchTier(t.shown.name),e==="samples"&&t.setSampling({rounds:n.samples??256}),e==="jitter"&&t.setSampling({jitter:n.jitter??1}),["camera-orbit","camera-target","field-of-view"].includes(e)&&t.glideTo(()=>t.placeCamera()),/^(min|max)-/.test(e)&&t.limitCamera(),["sun","light-rotation","environment-intensity"].includes(e)&&t.placeLights(),e==="ground"&&t.setGround(n.ground??t.scene?.ground??!1),e==="skybox"&&t.changed(),e==="exposure"&&t.setExposure(n.exposure??t.scene?.exposure??0),e==="view-transform"&&t.setView(n.viewTransform??t.scene?.view??"srgb"),e==="pixel-ratio"&&t.resize(),["maps","tint"].includes(e)&&t.shown&&t.print(),["loading","reveal"].includes(e)&&this._begin(),e==="messages"&&this.notices.show(),["camera-controls","interaction-prompt"].includes(e)&&this._prompt(),(e.startsWith("auto-rotate")||e==="rotation-per-second")&&this._turn(),this._describe()}_begin(){let{stage:e,settings:t}=this,n=t.reveal!=="manual"||this.isDismissed;if(this.parts.image.loading=t.loading==="eager"?"eager":"lazy",!this.isConnected||!this.observer||!(t.loading==="eager"||this.isNear&&n))return;if(!this.isBegun&&(this.isBegun=!0,e.begin(),this._turn(),t.environment&&!this.isLit&&this._light(),t.scene&&!e.scene))return void this._openScene();let s=t.src??e.scene?.asset??null;s!==this.requestedSrc&&this._open(s)}_open(e){this.requestedSrc=e,e!==null&&(this.loaded=!1,this.stage.open(this.requestedSrc))}_clear(){Object.assign(this,{loaded:!1,isBegun:!1}),this.turntable.switch(!1),this.stage.clear(),this._showImage(this.settings.poster)}async _openScene(){let{stage:e,settings:t}=this;if(t.scene===null)return e.leaveScene();this.isBegun?await e.openScene(t.scene)&&this._begin():e.scene=null}_light(){let{environment:e}=this.settings;this.isLit=!0,e!==null&&!Hm.includes(e)?this.stage.openImage(e,Nt(e)):this.stage.chooseImage(e??"studio")}_tint(){this.stage.setBackdrop(sr(getComputedStyle(this.parts.tint).backgroundColor))}_still(){this.stage.isStill=this.stillness.matches,this._turn(),this._prompt()}_turn(){let{autoRotate:e,autoRotateDelay:t,rotationPerSecond:n}=this.settings;Object.assign(this.turntable,{delay:t??3e3,speed:n??30}),this.turntable.switch(!!e&&this.isBegun&&!this.stage.isStill)}_listen(){let{stage:e,parts:t}=this,n=(s,i)=>e.addEventListener(s,i);t.tint.addEventListener("transitionend",()=>this._tint()),n("canvas",()=>this._describe()),n("progress",({got:s,all:i})=>this._showProgress(s,i)),n("poster",({blob:s})=>this.settings.poster||e.standIn.isShown||this._showImage(s&&URL.createObjectURL(s))),n("package",()=>this._describe()),n("loading",()=>this.failures.delete("asset")),n("shown",()=>this._reveal(e.isTouched)),n("load",()=>{this.loaded=!0,this._reveal(e.isTouched),t.status.textContent=Ze(this,"shown",{name:this._name()}),this._fire("progress",{totalProgress:1}),this._fire("load",{url:this.requestedSrc}),this._prompt()}),n("stand-in",()=>this._stand()),n("ended",()=>{t.loading.hidden=!0,this.notices.show()}),n("failed",({error:s,about:i})=>{this.failures.add(i),i==="engine"&&(t.poster.hidden=e.standIn.isShown),this._fire("error",{type:i,message:s.message,code:s.code??null,sourceError:s})});for(let s of["camera","light"])n(s,()=>this._reveal(!0));n("camera",({byUser:s})=>{this._fire("camera-change",{...En(e.orbit),source:s?"user-interaction":"none"}),s&&(this._moved(),this._speak())}),n("light",({byUser:s})=>this._fire("light-change",{...fr(e.lighting),source:s?"user-interaction":"none"}))}_stand(){let{parts:e,stage:t}=this;if(this.notices.show(),!t.standIn.isShown)return void(e.poster.hidden&&=this.loaded||t.isWhole);e.loading.hidden=!0,(!t.standIn.isPlain||!this._isCovered)&&this._hidePoster(),e.status.textContent=Ze(this,"shown",{name:this._name()}),this._fire("stand-in"),this._prompt()}_prompt(){clearTimeout(this.prompting);let{cameraControls:e,interactionPrompt:t}=this.settings,n=()=>e&&t!=="none"&&!this.hasMoved&&!this.stage.isStill;this.parts.prompt.hidden=!0,(this.loaded||this.stage.standIn.isShown)&&n()&&(this.prompting=setTimeout(()=>{this.parts.prompt.hidden=!n()},qm))}_moved(){this.hasMoved=!0,this._prompt()}_speak(){clearTimeout(this.speaking),this.speaking=setTimeout(()=>{this.parts.status.textContent=ma(this.stage.orbit,e=>Ze(this,e))},$m)}_showProgress(e,t){let{loading:n,bar:s,bytes:i}=this.parts;n.hidden=this.stage.standIn.isShown,t?Object.assign(s,{max:Math.max(t,e),value:e}):s.removeAttribute("value"),i.textContent=t?`${It(e)} / ${It(Math.max(t,e))}`:It(e),this._fire("progress",{totalProgress:t?Math.min(.99,e/t):0})}_showImage(e){let{image:t,poster:n}=this.parts;t.src.startsWith("blob:")&&URL.revokeObjectURL(t.src),t.hidden=!e,e?t.src=e:t.removeAttribute("src"),e&&(n.hidden=!1)}get _isCovered(){let{poster:e,image:t}=this.parts;return!e.hidden&&(!t.hidden||e.firstChild.assignedElements().length>0)}_reveal(e=!1){let t=this.settings.reveal!=="manual"||this.isDismissed;(this.loaded||this.stage.standIn.isPlain)&&t&&(e||this._isAsSharp())&&this._hidePoster()}_isAsSharp(){let{viewer:e,canvas:t}=this.stage,{image:n}=this.parts,{isSharp:s,scale:i}=e?.stats??{};if(!s)return!1;let a=n.hidden?1:Math.max(n.naturalWidth/t.width,n.naturalHeight/t.height);return 1/i>=Math.min(1,a)}get isSeen(){let{image:e}=this.parts;return this._isCovered&&(e.hidden||e.naturalWidth>0)||this.stage.standIn.isShown||this.loaded&&!!this.stage.viewer}get isStoodFor(){return this.stage.standIn.isShown||!!this.stage.loading||!(this.settings.src??this.stage.scene?.asset)}_hidePoster(){let{poster:e}=this.parts;e.hidden||(e.hidden=!0,this.turntable.wait(),this._fire("poster-dismissed"))}_name(){return this.settings.alt??this.stage.opened?.manifest.name??Ze(this,"asset")}_describe(){let{canvas:e}=this.stage,{parts:t}=this,{cameraControls:n}=this.settings;t.image.alt=this._name(),t.bar.setAttribute("aria-label",Ze(this,"loading"));for(let i of["prompt","keys"])t[i].textContent=Ze(this,i);if(!e)return;e.style.touchAction=this._touchAction();let s=n?{role:"application",tabindex:0,"aria-describedby":"keys"}:{role:"img"};e.setAttribute("aria-label",this._name());for(let i of["role","tabindex","aria-describedby"])i in s?e.setAttribute(i,s[i]):e.removeAttribute(i)}_touchAction(){let{cameraControls:e,touchAction:t,disableZoom:n}=this.settings;if(!e)return"auto";let s=t??"pan-y";return n?`${s==="none"?"":s} pinch-zoom`.trim():s}_fire(e,t=null){this.dispatchEvent(new CustomEvent(e,{detail:t}))}},Zm={cameraOrbit:({stage:r})=>En(r.view).cameraOrbit,cameraTarget:({stage:r})=>En(r.view).cameraTarget,fieldOfView:({stage:r})=>En(r.view).fieldOfView,sun:({stage:r})=>fr(r.lighting).sun,lightRotation:({stage:r})=>fr(r.lighting).lightRotation,environmentIntensity:({stage:r})=>r.lighting.strength,exposure:({stage:r})=>r.look.exposure,viewTransform:({stage:r})=>r.look.view,tier:({stage:r,settings:e})=>r.shown?.name??e.tier};function Ym(r,e){let t=r.settings[Xt(e)],n=r.getAttribute(e);return t===null||Number(n)===t?t:n}for(let[r,e]of Object.entries(at)){let t=Xt(r),n=e===Ye;Object.defineProperty(cs.prototype,t,{get(){return Zm[t]?.(this)??(n?this.settings[t]===!0:Ym(this,r))},set(s){let i=n?s?"":null:s;i==null?this.removeAttribute(r):this.setAttribute(r,i)},enumerable:!0,configurable:!0})}globalThis.customElements&&!customElements.get("rna-viewer")&&customElements.define("rna-viewer",cs);})();
/*! Bundled license information:

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
