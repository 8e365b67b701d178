(()=>{var Qt=class extends Error{constructor(e,t,n){super(`${t?t+": ":""}${n} [${e}]`),this.code=e,this.where=t}};function y(r,e,t){throw new Qt(r,e,t)}var G=class extends Error{};var Gs=65536,qs=16384,Ya=2**30,Et=class{constructor(e,t){this.blob=e,this.name=t,this.size=e.size}expect(){}async read(e,t){return new Uint8Array(await this.blob.slice(e,t).arrayBuffer())}},Fn=class r{static async open(e,t=()=>{},n,s=en(e)){let i=new r;Object.assign(i,{url:e,progress:t,signal:n,name:s,fetched:0,begun:0,expected:null});let o=await i._ask({Range:`bytes=0-${Gs-1}`}),c=/\/(\d+)$/.exec(o.headers.get("Content-Range")??"");i.ranged=o.status===206&&c!==null,o.status===206&&!i.ranged&&(await o.body?.cancel(),o=await i._ask({}));let l=Number(o.headers.get("Content-Length"))||0;i.ranged||(i.expected=l);let f=i.ranged?Gs:Ya;return l>f&&await i._tooLong(o,f),i.head=await i._collect(o,f),i.size=i.ranged?Number(c[1]):i.head.length,i}async read(e,t){if(!this.ranged||t<=this.head.length)return this.head.subarray(e,Math.min(t,this.size));let n=Math.max(0,this.size-qs);return e<n?this._range(e,t):(this.tail??=this._range(n,this.size),(await this.tail).subarray(e-n,t-n))}expect(e){if(!this.ranged)return;let t=([s,i])=>i<=this.head.length||s>=this.size-qs,n=e.filter(s=>!t(s)).reduce((s,[i,o])=>s+o-i,0);Object.assign(this,{begun:this.fetched,expected:n})}async _range(e,t){let n=await this._ask({Range:`bytes=${e}-${t-1}`});if(n.status!==206)throw new G(`${this.name}: the server forgot about ranges`);let s=await this._collect(n,t-e);if(s.length<t-e)throw new G(`${this.name}: the server sent ${s.length} bytes of ${t-e}`);return s}async _ask(e){let t;try{t=await fetch(this.url,{headers:e,signal:this.signal})}catch(n){if(n.name==="AbortError")throw n;let s=new URL(this.url,location.href).protocol==="file:";throw new G(s?"a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here":`cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`)}if(!t.ok&&t.status!==416)throw new G(`cannot load ${this.url}: HTTP ${t.status}`);return t}async _collect(e,t){if(e.status===416||!e.body)return new Uint8Array;let n=[],s=0,i=e.body.getReader();for(;;){let{done:l,value:f}=await i.read();if(l)break;s+=f.length,s>t&&await this._tooLong(i,t),n.push(f),this.fetched+=f.length,this.progress(this.fetched-this.begun,this.expected)}let o=new Uint8Array(s),c=0;for(let l of n)o.set(l,c),c+=l.length;return o}async _tooLong(e,t){throw await(e.body??e).cancel().catch(()=>{}),new G(this.ranged?`${this.name}: the server sent more than the ${t} bytes that were asked for`:`${this.name}: more than ${t} bytes from a server without range requests: use rna-view, or a server that has them`)}};function en(r){let e=new URL(r,location.href).pathname.split("/").pop();try{return decodeURIComponent(e)||r}catch{return e}}var Cn=class{constructor(e){Object.assign(this,{place:e,lines:new Map})}say(e,t=!1,n="page"){e?this.lines.set(n,{text:e,calm:t}):this.lines.delete(n);let s=[...this.lines.values()],i=new Set(s.map(o=>o.text));this.place.hidden=!s.length,this.place.replaceChildren(...[...i].map(o=>Object.assign(document.createElement("span"),{textContent:o}))),this.place.classList.toggle("calm",s.every(o=>o.calm))}},js=(r,e,t)=>Math.min(Math.max(r,e),t),zn=r=>((r+180)%360+360)%360-180;function ht(r){return r<1e6?`${Math.round(r/1e3)} kB`:`${(r/1e6).toFixed(r<1e7?2:1)} MB`}var Zs={azimuth:.6,elevation:.35,fov:30},Ys=89*Math.PI/180,Wa=.95,Be=(r,e,t=1)=>r.map((n,s)=>n+t*e[s]),tn=(r,e)=>r.map(t=>t*e),Sr=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),Va=r=>tn(r,1/Math.hypot(...r)),Ws=([r,e,t],[n,s,i])=>[e*i-t*s,t*n-r*i,r*s-e*n],Ir=r=>Math.min(Ys,Math.max(-Ys,r));function Vs(r,e,t){let n=Be(r,e,-1),s=Math.hypot(...n);return{azimuth:Math.atan2(n[0],n[2]),elevation:Math.asin(n[1]/s),distance:s,target:e,fov:t}}var Un=class{constructor(){Object.assign(this,{target:[0,0,0],distance:1,size:1,turntable:0,...Zs})}place(e,t,n,s){let i=e.map(_=>Object.fromEntries(Object.entries(_).filter(([,w])=>w!=null))),{azimuth:o,elevation:c,fov:l,target:f=[],distance:p,share:d=1}=Object.assign({},Zs,...i);Object.assign(this,{azimuth:o,elevation:c,fov:l}),t&&this.frame(t,n,s),this.distance=p??d*this.distance,this.target=this.target.map((_,w)=>f[w]??_)}frame({min:e,max:t},n,s=!1){this.target=tn(Be(e,t),.5),this.size=Math.hypot(...Be(t,e,-1))/2||1;let i=Wa*Math.tan(this.fov*Math.PI/360),o=Array.from({length:8},(f,p)=>Be([0,1,2].map(d=>(p>>d&1?t:e)[d]),this.target,-1)),l=(s?Array.from({length:16},(f,p)=>p*Math.PI/8):[this.turntable]).flatMap(f=>{let{forward:p,side:d,above:_}=this._axes(f);return o.map(w=>Math.max(Math.abs(Sr(w,_)),Math.abs(Sr(w,d))/n)/i-Sr(w,p))});this.distance=Math.max(...l)||this.size}get position(){return Be(this.target,this._away(this.turntable),this.distance)}turn(e,t){this.azimuth+=e,this.elevation=Ir(this.elevation+t)}zoom(e){this.distance=Math.min(1e4*this.size,Math.max(.001*this.size,this.distance*e))}pan(e,t){let{side:n,above:s}=this._axes(),i=2*this.distance*Math.tan(this.fov*Math.PI/360);this.target=Be(Be(this.target,n,e*i),s,t*i)}camera(e,t){let{forward:n,side:s,above:i}=this._axes(),o=Math.tan(this.fov*Math.PI/360),c=o*e/t;return{position:this.position,corner:Be(Be(n,s,-c),i,o),stepX:tn(s,2*c/e),stepY:tn(i,-2*o/t)}}_away(e){let t=Math.cos(this.elevation),n=this.azimuth+e;return[t*Math.sin(n),Math.sin(this.elevation),t*Math.cos(n)]}_axes(e=this.turntable){let t=tn(this._away(e),-1),n=Va(Ws(t,[0,1,0]));return{forward:t,side:n,above:Ws(n,t)}}};var $e=Math.PI/180,Ka={deg:$e,rad:1},Xa={m:1,cm:.01,mm:.001},Ja={"%":.01};function Hn(r,e){throw new Error(`expected ${r}, found ${JSON.stringify(e)}`)}function Tr(r,e){let[,t,n]=/^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)([a-z%]+)$/i.exec(r)??[];return Object.hasOwn(e,n??"")?Number(t)*e[n]:null}function nn(r,e,t){let n=r.trim().split(/\s+/);return n.length!==t.length&&Hn(e,r),n.map((s,i)=>s==="auto"?null:t[i](s)??Hn(e,r))}var Tt=r=>Tr(r,Ka),Dn=r=>Tr(r,Xa),Rt=(r,e,t=!1)=>n=>{let s=Number(n);return n.trim()!==""&&s>=r&&s<=e&&(!t||Number.isInteger(s))?s:Hn(`a ${t?"whole ":""}number from ${r} to ${e}`,n)},kt=(...r)=>e=>r.includes(e)?e:Hn(r.join(" or "),e),St=r=>r,Ve=()=>!0;function Qa(r){let e=o=>Dn(o)??Tr(o,Ja),[t,n,s]=nn(r,"THETA PHI RADIUS, as 45deg 75deg 2m",[Tt,Tt,e]),i=r.trim().endsWith("%");return{azimuth:t,elevation:n===null?null:Ir(Math.PI/2-n),distance:i?null:s,share:i?s:null}}var ec=r=>nn(r,"X Y Z, as 0m 0.5m 0m",[Dn,Dn,Dn]);function tc(r){let[e]=nn(r,"an angle, as 30deg",[Tt]);return e===null?null:Math.min(170,Math.max(1,e/$e))}var Ks=r=>nn(r,"an angle, as 90deg",[Tt])[0]/$e;function nc(r){if(r.trim()==="none")return{sun:0};let e=i=>i>=0?Number(i):null,[t,n,s]=nn(r,"none or AZIMUTH HEIGHT BRIGHTNESS, as 40deg 45deg 2",[Tt,Tt,e]);return{sunAzimuth:(t??40*$e)/$e,sunHeight:(n??45*$e)/$e,sun:s??2}}var rn={src:St,alt:St,poster:St,scene:St,environment:St,tier:St,loading:kt("auto","lazy","eager"),reveal:kt("auto","manual"),"camera-orbit":Qa,"camera-target":ec,"field-of-view":tc,sun:nc,"light-rotation":Ks,"environment-intensity":Rt(0,1e6),ground:Ve,exposure:Rt(-30,30),"view-transform":kt("srgb","filmic"),"camera-controls":Ve,"disable-zoom":Ve,"disable-pan":Ve,"disable-light":Ve,"touch-action":kt("pan-y","pan-x","none"),"wheel-zoom":kt("focus","always"),"auto-rotate":Ve,"auto-rotate-delay":Rt(0,1e9),"rotation-per-second":Ks,samples:Rt(1,1e6,!0),"pixel-ratio":Rt(.1,8),jitter:Rt(0,1),"first-look":kt("auto","off")},$n=r=>r.replace(/-(.)/g,(e,t)=>t.toUpperCase()),Bn=r=>String(Number(r.toPrecision(6))),It=r=>`${Bn(r)}deg`,Xs=r=>`${Bn(r)}m`;function sn({azimuth:r,elevation:e,distance:t,target:n,fov:s}){let i=r/$e,o=i-360*Math.round(i/360);return{cameraOrbit:`${It(o)} ${It(90-e/$e)} ${Xs(t)}`,cameraTarget:n.map(Xs).join(" "),fieldOfView:It(s)}}function Gn({rotation:r,strength:e,suns:t,sun:n,sunAzimuth:s,sunHeight:i}){return{sun:t||!(n>0)?"none":`${It(s)} ${It(i)} ${Bn(n)}`,lightRotation:It(r),environmentIntensity:Bn(e)}}function Js(r){let e=new OffscreenCanvas(1,1).getContext("2d");e.fillStyle=r,e.fillRect(0,0,1,1);let[t,n,s,i]=[...e.getImageData(0,0,1,1).data].map(o=>o/255);return i<1?null:[t,n,s].map(o=>o<=.04045?o/12.92:((o+.055)/1.055)**2.4)}var rc="Arrow keys or one finger orbit. Plus, minus or a pinch go nearer and farther. Square brackets, Shift and arrow keys, or two fingers turn the light. Home resets.";function ue(r,e,...t){let n=document.createElement(r);for(let[s,i]of Object.entries(e))n.setAttribute(s,i);return n.append(...t),n}var sc=()=>[ue("i",{id:"tint"}),ue("div",{id:"view",part:"view"}),ue("slot",{}),ue("div",{id:"poster"},ue("slot",{name:"poster"},ue("img",{part:"poster",alt:"",hidden:""}))),ue("div",{id:"over"},ue("div",{id:"loading",hidden:""},ue("slot",{name:"progress-bar"},ue("progress",{id:"bar",part:"progress-bar","aria-label":"Loading"}),ue("span",{id:"bytes"}))),ue("p",{id:"notice",part:"notice",role:"alert",hidden:""})),ue("p",{id:"keys",class:"spoken"},rc),ue("p",{id:"status",class:"spoken",role:"status"})],ic=`
:host {
  display: block; position: relative; overflow: hidden; width: 100%; aspect-ratio: 16 / 10;
  background-color: rgb(64, 67, 71); color: #fff; font: 13px/1.45 system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif;
}
:host([hidden]), [hidden] { display: none !important; }
#view, canvas, #poster, #poster img, ::slotted([slot="poster"]) { position: absolute; inset: 0; width: 100%; height: 100%; }
#tint { position: absolute; background-color: inherit; transition: background-color 1ms; }
canvas { display: block; }
canvas:focus-visible { outline: 2px solid #fff; outline-offset: -2px; }
:host([camera-controls]) canvas { cursor: grab; }
:host([camera-controls]) canvas.dragging { cursor: grabbing; }
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
.spoken { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`,qn=null;function Qs(r){let e=r.attachShadow({mode:"open",delegatesFocus:!0});return qn??=new CSSStyleSheet,qn.cssRules.length||qn.replaceSync(ic),e.adoptedStyleSheets=[qn],e.append(...sc()),e}var oc=["front","front right","right","back right","back","back left","left","front left"],ei=20*Math.PI/180;function ti({azimuth:r,elevation:e}){let t=Math.round(4*r/Math.PI),n=oc[(t%8+8)%8],s=e>ei?", from above":e<-ei?", from below":"";return`View from the ${n}${s}`}var Nr={note:"Generated by `python -m rna_gpu.records.write_records`; do not edit.",constants:{MAX_LAYERS:32,MAX_EXACT_INPUTS:512,UNIFORM_WEIGHTS:4096,RNA_NONE:4294967295,RNA_FLOAT32:0,RNA_FLOAT16:1,RNA_INT8:2,RNA_BLOCK_FEATURES:0,RNA_BLOCK_POSITION:1,RNA_BLOCK_NORMAL:2,RNA_BLOCK_TANGENT:3,RNA_BLOCK_H:4,RNA_BLOCK_WO:5,RNA_BLOCK_WI:6,RNA_BLOCK_HALF_VECTOR:7,RNA_BLOCK_HIGHLIGHT:8,RNA_BLOCK_LEARNED_NORMAL:9,RNA_BLOCK_FIBER_ANGLES:10,RNA_BLOCK_FIBER_LOBES:11,RNA_CHANNEL_GROUPS:16,RNA_NOTHING:4294967295,RNA_IS_SEGMENT:1,RNA_SURFACE_SHIFT:1,RNA_HAS_BEFORE:1,RNA_HAS_AFTER:2,NONE:4294967295,SUM_BEAUTY:0,SUM_NORMAL:1,SUM_POSITION:2,SUM_LIGHT_SAMPLES:3,SUM_BEHIND:4,IS_LIGHT:2147483648,MATERIAL_PART:4294967294,CATCHER_PART:4294967293,SUM_GROUPS:5,CAMERA_RAY:1,SHADOW_RAY:4,ALL_DIRECTIONS:4294967295,HEMISPHERE:4294967294,CHOICES:1,DIRECTION:2,ROULETTE:3,LIGHT:4,DIMENSIONS:7,HAS_SKY:1,FOR_BETA:2,RAYS_MEET_LIGHTS:4,FOR_EMISSION:8,FOR_LIGHT:16,TRANSMITS:32,OF_MATERIAL:0,OF_NEURAL:1,OF_FIBERS:2,EMITS:1,LETS_THROUGH:2,IS_GLASS:4,HAS_CUTOFF:8,HAS_SCHLICK:16,BASE:0,METAL:1,COAT:2,GLOW:3,CLEAR:4,CLEAR_ROUGH:5,THROUGH:6,RELIEF:7,LIGHT_SEEN:1,LIGHT_DELTA:2,LIGHT_INFINITE:4,DIRECTIONAL:0,DISK:1,IMAGE:2,POINT:3,RECTANGLE:4,SPHERE:5,SPOT:6,SUN:7,TRIANGLES:8,UNIFORM:9},records:{RnaLayer:{words:8,members:{inputs:{at:0,type:"u32",count:1},outputs:{at:1,type:"u32",count:1},weights:{at:2,type:"u32",count:1},bias:{at:3,type:"u32",count:1},units:{at:4,type:"u32",count:1},relu:{at:5,type:"u32",count:1},int8_step:{at:6,type:"f32",count:1},reserved:{at:7,type:"u32",count:1}}},RnaPart:{words:484,members:{low:{at:0,type:"f32",count:3},resolution:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},channel_groups:{at:7,type:"u32",count:1},query_groups:{at:8,type:"u32",count:1},layer_count:{at:9,type:"u32",count:1},plane_precision:{at:10,type:"u32",count:1},gain:{at:11,type:"u32",count:1},query_low:{at:12,type:"f32",count:1},query_high:{at:13,type:"f32",count:1},top:{at:14,type:"f32",count:1},unit:{at:15,type:"f32",count:1},matrix:{at:16,record:"RnaLayer",count:1},scales:{at:24,type:"f32",count:192},layers:{at:216,record:"RnaLayer",count:32},slots:{at:472,type:"u32",count:12}}},RnaRow:{words:16,members:{position:{at:0,type:"u32",count:3},h:{at:3,type:"u32",count:1},axis:{at:4,type:"u32",count:3},reserved:{at:7,type:"u32",count:1},wo:{at:8,type:"u32",count:3},reserved_2:{at:11,type:"u32",count:1},wi:{at:12,type:"u32",count:3},reserved_3:{at:15,type:"u32",count:1}}},RnaNode:{words:8,members:{low:{at:0,type:"f32",count:3},child:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},count:{at:7,type:"u32",count:1}}},RnaPrimitive:{words:4,members:{a:{at:0,type:"u32",count:1},b:{at:1,type:"u32",count:1},c:{at:2,type:"u32",count:1},tag:{at:3,type:"u32",count:1}}},RnaInstance:{words:32,members:{to_object:{at:0,type:"f32",count:12},rotation:{at:12,type:"f32",count:12},place:{at:24,type:"f32",count:3},scale:{at:27,type:"f32",count:1},root:{at:28,type:"u32",count:1},rays:{at:29,type:"u32",count:1},extent:{at:30,type:"f32",count:1},own:{at:31,type:"u32",count:1}}},Frame:{words:40,members:{camera:{at:0,type:"f32",count:3},width:{at:3,type:"u32",count:1},corner:{at:4,type:"f32",count:3},paths:{at:7,type:"u32",count:1},step_x:{at:8,type:"f32",count:3},sample:{at:11,type:"u32",count:1},step_y:{at:12,type:"f32",count:3},seed:{at:15,type:"u32",count:1},depth:{at:16,type:"u32",count:1},light:{at:17,type:"u32",count:1},part:{at:18,type:"u32",count:1},parts:{at:19,type:"u32",count:1},rays:{at:20,type:"u32",count:1},clamp:{at:21,type:"f32",count:1},light_count:{at:22,type:"u32",count:1},sums:{at:23,type:"u32",count:1},flags:{at:24,type:"u32",count:1},branch:{at:25,type:"u32",count:1},branches:{at:26,type:"u32",count:1},neural_part:{at:27,type:"u32",count:1},list:{at:28,type:"u32",count:1},next_list:{at:29,type:"u32",count:1},table_size:{at:30,type:"u32",count:1},objects:{at:31,type:"u32",count:1},surfaces:{at:32,type:"u32",count:1},lights:{at:33,type:"u32",count:1},albedo:{at:34,type:"u32",count:1},domains:{at:35,type:"u32",count:1},textures:{at:36,type:"u32",count:1}}},Path:{words:24,members:{origin:{at:0,type:"f32",count:3},pixel:{at:3,type:"u32",count:1},direction:{at:4,type:"f32",count:3},pdf:{at:7,type:"f32",count:1},beta:{at:8,type:"f32",count:3},state:{at:11,type:"u32",count:1},normal:{at:12,type:"f32",count:3},t:{at:15,type:"f32",count:1},instance:{at:16,type:"u32",count:1},primitive:{at:17,type:"u32",count:1},own:{at:18,type:"u32",count:1},b1:{at:19,type:"f32",count:1},leaving:{at:20,type:"f32",count:3},b2:{at:23,type:"f32",count:1}}},Query:{words:24,members:{x:{at:0,type:"f32",count:3},h:{at:3,type:"f32",count:1},axis:{at:4,type:"f32",count:3},part:{at:7,type:"u32",count:1},wo:{at:8,type:"f32",count:3},light:{at:11,type:"u32",count:1},wi:{at:12,type:"f32",count:3},strand:{at:15,type:"u32",count:1},weight:{at:16,type:"f32",count:3},seen:{at:19,type:"f32",count:1},visible:{at:20,type:"f32",count:3},reserved:{at:23,type:"u32",count:1}}},PathQueries:{words:48,members:{at_point:{at:0,record:"Query",count:1},at_light:{at:24,record:"Query",count:1}}},Object:{words:4,members:{number:{at:0,type:"f32",count:1},catches:{at:1,type:"u32",count:1},step:{at:2,type:"f32",count:1},passes:{at:3,type:"u32",count:1}}},Surface:{words:36,members:{kind:{at:0,type:"u32",count:1},part:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},normal_map:{at:3,type:"u32",count:1},base_color:{at:4,type:"f32",count:3},roughness:{at:7,type:"f32",count:1},metallic:{at:8,type:"f32",count:1},coat_f0:{at:9,type:"f32",count:1},coat_weight:{at:10,type:"f32",count:1},transmission:{at:11,type:"f32",count:1},emission:{at:12,type:"f32",count:3},normal_scale:{at:15,type:"f32",count:1},clear_coat:{at:16,type:"f32",count:1},clear_coat_roughness:{at:17,type:"f32",count:1},second_uvs:{at:18,type:"u32",count:1},tangents:{at:19,type:"u32",count:1},textures:{at:20,type:"u32",count:8},through:{at:28,type:"u32",count:1},cutoff:{at:29,type:"f32",count:1},ior:{at:30,type:"f32",count:2},f0:{at:32,type:"f32",count:1}}},Texture:{words:12,members:{place:{at:0,type:"u32",count:1},size:{at:1,type:"u32",count:1},form:{at:2,type:"u32",count:1},row_u:{at:4,type:"f32",count:3},row_v:{at:8,type:"f32",count:3}}},Light:{words:32,members:{kind:{at:0,type:"u32",count:1},group:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},instance:{at:3,type:"u32",count:1},numbers:{at:4,type:"f32",count:20},probability:{at:24,type:"f32",count:3},places:{at:28,type:"u32",count:4}}}},lights:{directional:{colour:0,axis:3},disk:{colour:0,frame:3,radius:15},image:{colour:0,turn_cosine:3,turn_sine:4,total:5,mean:6,rows:7,columns:8},point:{colour:0,place:3},rectangle:{colour:0,frame:3,half:15},sphere:{colour:0,centre:3,radius:6},spot:{colour:0,place:3,axis:6,cos_inner:9,cos_outer:10},sun:{colour:0,axis:3,one_minus_cosine:6},triangles:{colour:0,rotation:3,place:12,scale:15},uniform:{colour:0}},viewerLights:{sun:0,environment:1,given:2,aroundPoint:3,mirror:4}};var{constants:ce,records:_e,viewerLights:Or}=Nr;function ni(r){for(let[,e,t]of r.matchAll(/struct (\w+) \{([^}]*)\}/g)){let n={},s=0;for(let[,i,o]of t.matchAll(/^\s*(\w+): ([\w<>]+)/gm)){let c=Number(/vec(\d)/.exec(o)?.[1]??1),l=c===3?4:c,f=Math.ceil(s/l)*l;n[i]={at:f,type:o.includes("u32")?"u32":"f32",count:c},s=f+c}_e[e]={words:4*Math.ceil(s/4),members:n}}}function ae(r,e){let t=new Uint32Array(_e[r].words);return ii(t,new Float32Array(t.buffer),0,r,e),t}var ri=Object.entries(Or).map(([r,e])=>`const LIGHT_${r.replace(/[A-Z]/g,"_$&").toUpperCase()}: u32 = ${e}u;`).join(`
`),Ke=r=>4*_e[r].words;function si(r,e){let t=[];for(let[n,s]of Object.entries(e))[s].flat().forEach((i,o)=>{t[Nr.lights[r][n]+o]=i});return Float32Array.from(t,n=>n??0)}function ii(r,e,t,n,s){for(let[i,o]of Object.entries(s)){let{at:c,type:l,record:f}=_e[n].members[i],p=t+c,d=typeof o=="number"?[o]:o;f?[d].flat().forEach((_,w)=>ii(r,e,p+w*_e[f].words,f,_)):(l==="f32"?e:r).set(d,p)}}function*on(r,e,t){for(let n=r;n<e;n+=8192)t(n,Math.min(e,n+8192)),n+8192<e&&(yield)}async function jn(r){for(let e=performance.now();;){let{done:t,value:n}=r.next();if(t)return n;performance.now()-e<20||(await cc(),e=performance.now())}}function cc(){let{port1:r,port2:e}=new MessageChannel;return new Promise(t=>{r.onmessage=()=>{r.close(),t()},e.postMessage(null)})}var{words:Mr,members:an}=_e.RnaNode,Ge=16,lc=4,oi=256,uc=24;function*ci(r,e=0){let t=r.length/6,n=Uint32Array.from({length:t},(p,d)=>d),s=new Float32Array(3*t);for(let p=0;p<t;p++)for(let d=0;d<3;d++)s[3*p+d]=.5*(r[6*p+d]+r[6*p+3+d]);let i=new Float32Array(2*Mr*t),o=new Uint32Array(i.buffer),c={boxes:r,centres:s,order:n},l=[[0,t,0,-1]],f=0;for(;l.length;){let[p,d,_,w]=l.pop(),A=Mr*f;f+=1,w>=0&&(o[w+an.child.at]=e+f-1),d-p>oi&&(yield),fc(c,p,d);for(let H=0;H<3;H++)i[A+an.low.at+H]=ve[H],i[A+an.high.at+H]=ve[3+H];if(d-p<=lc){o[A+an.child.at]=p,o[A+an.count.at]=d-p;continue}let R={cost:1/0};for(let H=0;H<3&&_<uc;H++){let Z=hc(c,p,d,H);Z.cost<R.cost&&(R=Z),d-p>oi&&(yield)}let L=R.cost<1/0?pc(c,p,d,R):p;p<L&&L<d||(L=dc(c,p,d)),l.push([L,d,_+1,A],[p,L,_+1,-1])}return{nodes:o.slice(0,Mr*f),order:n}}function zr(r,e,t,n){for(let s=0;s<3;s++)r[e+s]=Math.min(r[e+s],t[n+s]),r[e+3+s]=Math.max(r[e+3+s],t[n+3+s])}function Ur(r){for(let e=0;e<r.length;e+=6)for(let t=0;t<3;t++)r[e+t]=1/0,r[e+3+t]=-1/0;return r}var ve=new Float32Array(6),Fr=new Float32Array(6*Ge),Cr=new Uint32Array(Ge),Lr=new Float64Array(Ge),Pr=new Float64Array(Ge);function fc({boxes:r,order:e},t,n){Ur(ve);for(let s=t;s<n;s++)zr(ve,0,r,6*e[s])}function li({centres:r,order:e},t,n,s){let i=1/0,o=-1/0;for(let c=t;c<n;c++){let l=r[3*e[c]+s];i=Math.min(i,l),o=Math.max(o,l)}return[i,o]}var ui=(r,e,t)=>Math.min(Math.floor((r-e)/(t-e)*Ge),Ge-1);function hc(r,e,t,n){let{boxes:s,centres:i,order:o}=r,[c,l]=li(r,e,t,n);if(!(l>c))return{cost:1/0};Ur(Fr),Cr.fill(0);for(let d=e;d<t;d++){let _=ui(i[3*o[d]+n],c,l);Cr[_]+=1,zr(Fr,6*_,s,6*o[d])}ai(Pr,Ge-1,-1),ai(Lr,0,1);let f=1/0,p=0;for(let d=1;d<Ge;d++)Lr[d-1]+Pr[d]<f&&(f=Lr[d-1]+Pr[d],p=d);return{cost:f,cut:p,axis:n,low:c,high:l}}function ai(r,e,t){Ur(ve);for(let n=e,s=0;n>=0&&n<Ge;n+=t){zr(ve,0,Fr,6*n),s+=Cr[n];let i=ve[3]-ve[0],o=ve[4]-ve[1],c=ve[5]-ve[2];r[n]=s?(i*o+o*c+c*i)*s:1/0}}function pc({centres:r,order:e},t,n,{axis:s,cut:i,low:o,high:c}){let l=t,f=n-1;for(;l<=f;){let p=e[l];ui(r[3*p+s],o,c)<i?l++:(e[l]=e[f],e[f--]=p)}return l}function dc(r,e,t){let{centres:n,order:s}=r,i=[0,1,2].map(c=>{let[l,f]=li(r,e,t,c);return f-l}),o=i.indexOf(Math.max(...i));return s.subarray(e,t).sort((c,l)=>n[3*c+o]-n[3*l+o]),Math.floor((e+t)/2)}var{NONE:mc,OF_NEURAL:gc,OF_FIBERS:_c,LETS_THROUGH:fi,HAS_CUTOFF:vc}=ce,Zn=class{constructor(){Object.assign(this,{surfaces:[],textures:[],images:[],imagesLength:0})}ofFibers(e){return this._add({kind:_c,part:e})}ofTriangles({mesh:e,transmittance:t,normalMaps:n},s){let i=e.indices.length/3,o=hi(t,i),c=hi(n,i),l=new Map,f=new Uint32Array(i);for(let p=0;p<i;p++){let d=`${c[p]} ${o[p]}`;l.has(d)||l.set(d,this._ofRecords(s,n[c[p]],t[o[p]])),f[p]=l.get(d)}return f}arrays(){let e=this.surfaces.map(i=>ae("Surface",i)),t=Uint32Array.from([...e,...this.textures].flatMap(i=>[...i])),n=new Uint32Array(this.imagesLength),s=0;for(let i of this.images)n.set(i,s),s+=i.length;return{table:t,images:n,texturesAt:e.reduce((i,o)=>i+o.length/4,0),hasTextures:this.textures.length>0,transmits:this.surfaces.some(({flags:i})=>i&fi)}}_add(e){return this.surfaces.push({normal_map:mc,...e})-1}_ofRecords(e,t,n){let s={kind:gc,part:e};return t&&(s.normal_map=this._texture(t.texture)),n&&(s.flags=fi|(n.cutoff==null?0:vc),Object.assign(s,{through:this._texture(n.texture),cutoff:n.cutoff??0,ior:n.ior??[0,0]})),this._add(s)}_texture({values:e,width:t,height:n,channels:s}){let i=new Uint32Array(t*n),o=this.imagesLength;for(let c=0;c<i.length;c++){let[l,f=l,p=s===1?l:0]=e.subarray(s*c,s*(c+1));i[c]=l|f<<8|p<<16}return this.images.push(i),this.imagesLength+=i.length,this.textures.push(ae("Texture",{place:o,size:n<<16|t,row_u:[1,0,0],row_v:[0,1,0]}))-1}};function hi(r,e){let t=new Int32Array(e).fill(-1);return r.forEach(({triangles:[n,s]},i)=>t.fill(i,n,n+s)),t}var{RNA_HAS_BEFORE:yc,RNA_HAS_AFTER:wc,RNA_IS_SEGMENT:xc,RNA_SURFACE_SHIFT:pi}=ce,cn=_e.RnaPrimitive,Xe=_e.RnaNode,Yn=r=>jn(bc(r));function*bc(r){let e=r.map(Ac),t=p=>e.reduce((d,_)=>d+_[p],0),n={primitives:new Uint32Array(cn.words*t("primitives")),points:new Float32Array(4*t("points")),normals:new Float32Array(4*t("normals")),boxes:new Float32Array(6*t("primitives")),surfaces:new Zn,parts:[],extent:0,strands:0},s={primitive:0,point:0},i=[...r.keys()].sort((p,d)=>(r[p].kind==="fiber")-(r[d].kind==="fiber"));for(let p of i){let d=r[p];n.parts[p]={first:s.primitive,point:s.point,fiber:d.kind==="fiber"},d.kind==="fiber"?yield*Rc(n,d.curves,p,s):yield*Ec(n,d,p,s),s={primitive:s.primitive+e[p].primitives,point:s.point+e[p].points}}let{nodes:o,order:c}=yield*ci(n.boxes,1),l=new Uint32Array(n.primitives.length),f=new Uint32Array(c.length);return yield*on(0,c.length,(p,d)=>{for(let _=p;_<d;_++){let w=c[_],A=n.primitives.subarray(cn.words*w,cn.words*(w+1));l.set(A,cn.words*_),f[w]=_}}),{...n,boxes:null,...n.surfaces.arrays(),primitives:l,nodes:kc(o),where:f,box:Sc(o)}}function Ac({kind:r,mesh:e,curves:t}){if(r==="surface"){let s=e.positions.length/3;return{primitives:e.indices.length/3,points:s,normals:s}}let n=t.radii.length;return{primitives:n-(t.offsets.length-1),points:n,normals:0}}function*Ec(r,e,t,{primitive:n,point:s}){let{positions:i,normals:o,uvs:c,indices:l}=e.mesh,{points:f,boxes:p,primitives:d}=r;yield*on(0,i.length/3,(w,A)=>{for(let R=w;R<A;R++){let L=4*(s+R);for(let H=0;H<3;H++)f[L+H]=i[3*R+H],r.normals[L+H]=o[3*R+H],r.extent=Math.max(r.extent,Math.abs(i[3*R+H]));f[L+3]=c?c[2*R]:0,r.normals[L+3]=c?c[2*R+1]:0}});let _=r.surfaces.ofTriangles(e,t);yield*on(0,l.length/3,(w,A)=>{for(let R=w;R<A;R++){let L=[0,1,2].map(Q=>l[3*R+Q]),[H,Z,K]=L.map(Q=>Q+s);di(d,n+R,H,Z,K,_[R]<<pi);for(let Q=0;Q<3;Q++){let xe=L.map(Te=>i[3*Te+Q]);p[6*(n+R)+Q]=Math.min(...xe),p[6*(n+R)+3+Q]=Math.max(...xe)}}})}function*Rc(r,e,t,{primitive:n,point:s}){let{boxes:i,primitives:o}=r,{radii:c,offsets:l}=e,f=r.surfaces.ofFibers(t);yield*on(0,c.length,(d,_)=>{for(let w=d;w<_;w++){let[A,R,L]=e.points.subarray(3*w,3*w+3);r.points.set([A,R,L,c[w]],4*(s+w)),r.extent=Math.max(r.extent,Math.max(Math.abs(A),Math.abs(R),Math.abs(L))+c[w])}});let p=n;for(let d=0;d+1<l.length;d++,r.strands++){yield;for(let _=l[d];_+1<l[d+1];_++,p++){let w=(_>l[d]&&yc)|(_+2<l[d+1]&&wc);di(o,p,s+_,w,r.strands,f<<pi|xc);for(let A=0;A<3;A++){let R=e.points[3*_+A],L=e.points[3*_+3+A],H=c[_]*1.0005,Z=c[_+1]*1.0005;i[6*p+A]=Math.min(R-H,L-Z),i[6*p+3+A]=Math.max(R+H,L+Z)}}}}function di(r,e,t,n,s,i){let{members:o,words:c}=cn,l=c*e;r[l+o.a.at]=t,r[l+o.b.at]=n,r[l+o.c.at]=s,r[l+o.tag.at]=i}function kc(r){let e=new Uint32Array(r.length+Xe.words);return e.set(r.subarray(0,Xe.words)),e[Xe.members.child.at]=0,e[Xe.members.count.at]=1,e.set(r,Xe.words),e}function Sc(r){let e=new Float32Array(r.buffer,0,Xe.words),t=({at:n,count:s})=>[...e.subarray(n,n+s)];return{min:t(Xe.members.low),max:t(Xe.members.high)}}var mi=[1024,512];function gi(r){let{rgb:e,width:t,height:n}=Nc(r),s=[0,e.length,e.length+n+1,e.length+2*n+3],i=new Float32Array(s[3]+(n+1)*(t+1));i.set(e);let o=l=>Math.cos(Math.PI*Math.min(1,Math.max(0,(l-.5)/n))),c=0;for(let l=0;l<=n;l++){let f=o(l)-o(l+1),p=t*Math.max(l-1,0),d=t*Math.min(l,n-1);i[s[1]+l]=f;let _=0;for(let w=0;w<t;w++){let A=(w+1)%t,R=[p+w,p+A,d+w,d+A].reduce((L,H)=>L+Ic(e,H),0);_+=R/4*f,i[s[3]+l*(t+1)+w+1]=_}c+=_,i[s[2]+l+1]=c}return{floats:i,places:s,total:c,width:t,height:n,up:Tc(e,t,n)}}var Ic=(r,e)=>.2126*r[3*e]+.7152*r[3*e+1]+.0722*r[3*e+2];function Tc(r,e,t){let n=[0,0,0];for(let s=0;s<t;s++){let i=Math.PI*(s+.5)/t,o=2*Math.PI**2*Math.sin(i)/(e*t)*Math.max(0,Math.cos(i));for(let c=0;c<3*e;c++)n[c%3]+=r[3*e*s+c]*o}return n}function Nc({rgb:r,width:e,height:t}){let n=Math.max(1,Math.ceil(e/mi[0]),Math.ceil(t/mi[1]));if(n===1)return{rgb:r,width:e,height:t};let s=Math.ceil(e/n),i=Math.ceil(t/n),o=new Float32Array(3*s*i);for(let c=0;c<i;c++)for(let l=0;l<s;l++){let f=0;for(let p=c*n;p<Math.min(t,(c+1)*n);p++)for(let d=l*n;d<Math.min(e,(l+1)*n);d++,f++)for(let _=0;_<3;_++)o[3*(c*s+l)+_]+=r[3*(p*e+d)+_];for(let p=0;p<3;p++)o[3*(c*s+l)+p]/=f}return{rgb:o,width:s,height:i}}function Wn(r){return{rgb:Float32Array.from({length:96},(n,s)=>r[s%3]),width:8,height:4}}function _i(){let t=new Float32Array(24576),n=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let s=0;s<64;s++){let i=Math.PI*(s+.5)/64;for(let o=0;o<128;o++){let c=2*Math.PI*((o+.5)/128-.5),l=[Math.sin(i)*Math.sin(c),Math.cos(i),-Math.sin(i)*Math.cos(c)],f=.16+.14*Math.max(0,l[1]);for(let p=0;p<3;p++){let d=f*[.95,1,1.08][p];for(let[_,w,A]of n){let R=(l[0]*_[0]+l[1]*_[1]+l[2]*_[2])/Math.hypot(..._);d+=A[p]*Math.min(1,Math.max(0,(R-w)/.03))}t[3*(s*128+o)+p]=d}}}return{rgb:t,width:128,height:64}}function Nt(r){let e=new TextDecoder().decode(r.subarray(0,512)).trimStart();return e.startsWith("version https://git-lfs.github.com/")?"a pointer of Git LFS, in whose place `git lfs pull` puts the file":/^<(!doctype\s+html|html|head|body)\b/i.test(e)?"an HTML page: there is no such file, or it has another address":null}var Dr=0,Hr=1,Br=2,$r=3,Gr=4,qr=5,jr=6,Zr=7;var Yr=1006;var Ot=1015,Mt=1016;var Je=1023;var ln=1028;var Lt=1030;var Qe="srgb-linear";var vi=null;function Oc(r){let e=r[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=r[1];t&&t.isStackTrace?r[0]+=" "+t.getLocation():r[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return r}function yi(...r){r=Oc(r);let e="THREE."+r.shift();if(vi)vi("warn",e,...r);else{let t=r[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...r)}}var uh={[Dr]:Dr,[Br]:jr,[Gr]:Gr,[$r]:qr,[Hr]:Hr,[jr]:Br,[Zr]:Zr,[qr]:$r};var hh=Math.PI/180,ph=180/Math.PI;function wi(r,e,t){return Math.max(e,Math.min(t,r))}var qe=Mc();function Mc(){let r=new ArrayBuffer(4),e=new Float32Array(r),t=new Uint32Array(r),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){let f=l-127;f<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):f<-14?(n[l]=1024>>-f-14,n[l|256]=1024>>-f-14|32768,s[l]=-f-1,s[l|256]=-f-1):f<=15?(n[l]=f+15<<10,n[l|256]=f+15<<10|32768,s[l]=13,s[l|256]=13):f<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}let i=new Uint32Array(2048),o=new Uint32Array(64),c=new Uint32Array(64);for(let l=1;l<1024;++l){let f=l<<13,p=0;for(;(f&8388608)===0;)f<<=1,p-=8388608;f&=-8388609,p+=947912704,i[l]=f|p}for(let l=1024;l<2048;++l)i[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(c[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:s,mantissaTable:i,exponentTable:o,offsetTable:c}}function Lc(r){Math.abs(r)>65504&&yi("DataUtils.toHalfFloat(): Value out of range."),r=wi(r,-65504,65504),qe.floatView[0]=r;let e=qe.uint32View[0],t=e>>23&511;return qe.baseTable[t]+((e&8388607)>>qe.shiftTable[t])}function Pc(r){let e=r>>10;return qe.uint32View[0]=qe.mantissaTable[qe.offsetTable[e]+(r&1023)]+qe.exponentTable[e],qe.floatView[0]}var O=class{static toHalfFloat(e){return Lc(e)}static fromHalfFloat(e){return Pc(e)}};var Vn=class{};var ye=Uint8Array,Pt=Uint16Array,Fc=Int32Array,xi=new ye([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),bi=new ye([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Cc=new ye([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Ai=function(r,e){for(var t=new Pt(31),n=0;n<31;++n)t[n]=e+=1<<r[n-1];for(var s=new Fc(t[30]),n=1;n<30;++n)for(var i=t[n];i<t[n+1];++i)s[i]=i-t[n]<<5|n;return{b:t,r:s}},Ei=Ai(xi,2),Ri=Ei.b,zc=Ei.r;Ri[28]=258,zc[258]=28;var ki=Ai(bi,0),Uc=ki.b,xh=ki.r,Kr=new Pt(32768);for(V=0;V<32768;++V)je=(V&43690)>>1|(V&21845)<<1,je=(je&52428)>>2|(je&13107)<<2,je=(je&61680)>>4|(je&3855)<<4,Kr[V]=((je&65280)>>8|(je&255)<<8)>>1;var je,V,un=(function(r,e,t){for(var n=r.length,s=0,i=new Pt(e);s<n;++s)r[s]&&++i[r[s]-1];var o=new Pt(e);for(s=1;s<e;++s)o[s]=o[s-1]+i[s-1]<<1;var c;if(t){c=new Pt(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var f=s<<4|r[s],p=e-r[s],d=o[r[s]-1]++<<p,_=d|(1<<p)-1;d<=_;++d)c[Kr[d]>>l]=f}else for(c=new Pt(n),s=0;s<n;++s)r[s]&&(c[s]=Kr[o[r[s]-1]++]>>15-r[s]);return c}),fn=new ye(288);for(V=0;V<144;++V)fn[V]=8;var V;for(V=144;V<256;++V)fn[V]=9;var V;for(V=256;V<280;++V)fn[V]=7;var V;for(V=280;V<288;++V)fn[V]=8;var V,Si=new ye(32);for(V=0;V<32;++V)Si[V]=5;var V;var Dc=un(fn,9,1);var Hc=un(Si,5,1),Wr=function(r){for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},Re=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},Vr=function(r,e){var t=e/8|0;return(r[t]|r[t+1]<<8|r[t+2]<<16)>>(e&7)},Bc=function(r){return(r+7)/8|0},$c=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new ye(r.subarray(e,t))};var Gc=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],ke=function(r,e,t){var n=new Error(e||Gc[r]);if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,ke),!t)throw n;return n},qc=function(r,e,t,n){var s=r.length,i=n?n.length:0;if(!s||e.f&&!e.l)return t||new ye(0);var o=!t,c=o||e.i!=2,l=e.i;o&&(t=new ye(s*3));var f=function(An){var En=t.length;if(An>En){var Vt=new ye(Math.max(En*2,An));Vt.set(t),t=Vt}},p=e.f||0,d=e.p||0,_=e.b||0,w=e.l,A=e.d,R=e.m,L=e.n,H=s*8;do{if(!w){p=Re(r,d,1);var Z=Re(r,d+1,3);if(d+=3,Z)if(Z==1)w=Dc,A=Hc,R=9,L=5;else if(Z==2){var Te=Re(r,d,31)+257,Ze=Re(r,d+10,15)+4,xr=Te+Re(r,d+5,31)+1;d+=14;for(var lt=new ye(xr),Ue=new ye(19),se=0;se<Ze;++se)Ue[Cc[se]]=Re(r,d+se*3,7);d+=Ze*3;for(var wn=Wr(Ue),br=(1<<wn)-1,be=un(Ue,wn,1),se=0;se<xr;){var Wt=be[Re(r,d,br)];d+=Wt&15;var K=Wt>>4;if(K<16)lt[se++]=K;else{var de=0,wt=0;for(K==16?(wt=3+Re(r,d,3),d+=2,de=lt[se-1]):K==17?(wt=3+Re(r,d,7),d+=3):K==18&&(wt=11+Re(r,d,127),d+=7);wt--;)lt[se++]=de}}var xn=lt.subarray(0,Te),Ae=lt.subarray(Te);R=Wr(xn),L=Wr(Ae),w=un(xn,R,1),A=un(Ae,L,1)}else ke(1);else{var K=Bc(d)+4,Q=r[K-4]|r[K-3]<<8,xe=K+Q;if(xe>s){l&&ke(0);break}c&&f(_+Q),t.set(r.subarray(K,xe),_),e.b=_+=Q,e.p=d=xe*8,e.f=p;continue}if(d>H){l&&ke(0);break}}c&&f(_+131072);for(var bn=(1<<R)-1,Ar=(1<<L)-1,me=d;;me=d){var de=w[Vr(r,d)&bn],Ne=de>>4;if(d+=de&15,d>H){l&&ke(0);break}if(de||ke(2),Ne<256)t[_++]=Ne;else if(Ne==256){me=d,w=null;break}else{var Ee=Ne-254;if(Ne>264){var se=Ne-257,De=xi[se];Ee=Re(r,d,(1<<De)-1)+Ri[se],d+=De}var ut=A[Vr(r,d)&Ar],xt=ut>>4;ut||ke(3),d+=ut&15;var Ae=Uc[xt];if(xt>3){var De=bi[xt];Ae+=Vr(r,d)&(1<<De)-1,d+=De}if(d>H){l&&ke(0);break}c&&f(_+131072);var J=_+Ee;if(_<Ae){var He=i-Ae,Ye=Math.min(Ae,J);for(He+_<0&&ke(3);_<Ye;++_)t[_]=n[He+_]}for(;_<J;++_)t[_]=t[_-Ae]}}e.l=w,e.p=me,e.b=_,e.f=p,w&&(p=1,e.m=R,e.d=A,e.n=L)}while(!p);return _!=t.length&&o?$c(t,0,_):t.subarray(0,_)};var jc=new ye(0);var Zc=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&ke(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&ke(6,"invalid zlib data: "+(r[1]&32?"need":"unexpected")+" dictionary"),(r[1]>>3&4)+2};function Ft(r,e){return qc(r.subarray(Zc(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Yc=typeof TextDecoder<"u"&&new TextDecoder,Wc=0;try{Yc.decode(jc,{stream:!0}),Wc=1}catch{}var Kn=class extends Vn{constructor(e){super(e),this.type=Mt,this.outputFormat=Je,this.part=0}parse(e){let lt=Math.pow(2.7182818,2.2),Ue=null,se=null;function wn(a,u){let h=0;for(let v=0;v<65536;++v)(v==0||a[v>>3]&1<<(v&7))&&(u[h++]=v);let g=h-1;for(;h<65536;)u[h++]=0;return g}function br(a){for(let u=0;u<16384;u++)a[u]={},a[u].len=0,a[u].lit=0,a[u].p=null}let be={l:0,c:0,lc:0};function Wt(a,u,h,g,v){for(;h<a;)u=u<<8|Us(g,v),h+=8;h-=a,be.l=u>>h&(1<<a)-1,be.c=u,be.lc=h}let de=new Array(59);function wt(a){for(let h=0;h<=58;++h)de[h]=0;for(let h=0;h<65537;++h)de[a[h]]+=1;let u=0;for(let h=58;h>0;--h){let g=u+de[h]>>1;de[h]=u,u=g}for(let h=0;h<65537;++h){let g=a[h];g>0&&(a[h]=g|de[g]++<<6)}}function xn(a,u,h,g,v,b){let m=u,k=0,x=0;for(;g<=v;g++){if(m.value-u.value>h)return!1;Wt(6,k,x,a,m);let E=be.l;if(k=be.c,x=be.lc,b[g]=E,E==63){if(m.value-u.value>h)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");Wt(8,k,x,a,m);let S=be.l+6;if(k=be.c,x=be.lc,g+S>v+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;S--;)b[g++]=0;g--}else if(E>=59){let S=E-59+2;if(g+S>v+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;S--;)b[g++]=0;g--}}wt(b)}function Ae(a){return a&63}function bn(a){return a>>6}function Ar(a,u,h,g){for(;u<=h;u++){let v=bn(a[u]),b=Ae(a[u]);if(v>>b)throw new Error("THREE.EXRLoader: Invalid table entry");if(b>14){let m=g[v>>b-14];if(m.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(m.lit++,m.p){let k=m.p;m.p=new Array(m.lit);for(let x=0;x<m.lit-1;++x)m.p[x]=k[x]}else m.p=new Array(1);m.p[m.lit-1]=u}else if(b){let m=0;for(let k=1<<14-b;k>0;k--){let x=g[(v<<14-b)+m];if(x.len||x.p)throw new Error("THREE.EXRLoader: Invalid table entry");x.len=b,x.lit=u,m++}}}return!0}let me={c:0,lc:0};function Ne(a,u,h,g){a=a<<8|Us(h,g),u+=8,me.c=a,me.lc=u}let Ee={c:0,lc:0};function De(a,u,h,g,v,b,m,k,x){if(a==u){g<8&&(Ne(h,g,v,b),h=me.c,g=me.lc),g-=8;let E=h>>g;if(E=new Uint8Array([E])[0],k.value+E>x)return!1;let S=m[k.value-1];for(;E-- >0;)m[k.value++]=S}else if(k.value<x)m[k.value++]=a;else return!1;Ee.c=h,Ee.lc=g}function ut(a){return a&65535}function xt(a){let u=ut(a);return u>32767?u-65536:u}let J={a:0,b:0};function He(a,u){let h=xt(a),v=xt(u),b=h+(v&1)+(v>>1),m=b,k=b-v;J.a=m,J.b=k}function Ye(a,u){let h=ut(a),g=ut(u),v=h-(g>>1)&65535,b=g+v-32768&65535;J.a=b,J.b=v}function An(a,u,h,g,v,b,m){let k=m<16384,x=h>v?v:h,E=1,S,T;for(;E<=x;)E<<=1;for(E>>=1,S=E,E>>=1;E>=1;){T=0;let I=T+b*(v-S),M=b*E,F=b*S,N=g*E,P=g*S,D,q,B,Y;for(;T<=I;T+=F){let z=T,C=T+g*(h-S);for(;z<=C;z+=P){let U=z+N,X=z+M,W=X+N;k?(He(a[z+u],a[X+u]),D=J.a,B=J.b,He(a[U+u],a[W+u]),q=J.a,Y=J.b,He(D,q),a[z+u]=J.a,a[U+u]=J.b,He(B,Y),a[X+u]=J.a,a[W+u]=J.b):(Ye(a[z+u],a[X+u]),D=J.a,B=J.b,Ye(a[U+u],a[W+u]),q=J.a,Y=J.b,Ye(D,q),a[z+u]=J.a,a[U+u]=J.b,Ye(B,Y),a[X+u]=J.a,a[W+u]=J.b)}if(h&E){let U=z+M;k?He(a[z+u],a[U+u]):Ye(a[z+u],a[U+u]),D=J.a,a[U+u]=J.b,a[z+u]=D}}if(v&E){let z=T,C=T+g*(h-S);for(;z<=C;z+=P){let U=z+N;k?He(a[z+u],a[U+u]):Ye(a[z+u],a[U+u]),D=J.a,a[U+u]=J.b,a[z+u]=D}}S=E,E>>=1}return T}function En(a,u,h,g,v,b,m,k,x){let E=0,S=0,T=m,I=Math.trunc(g.value+(v+7)/8);for(;g.value<I;)for(Ne(E,S,h,g),E=me.c,S=me.lc;S>=14;){let F=E>>S-14&16383,N=u[F];if(N.len)S-=N.len,De(N.lit,b,E,S,h,g,k,x,T),E=Ee.c,S=Ee.lc;else{if(!N.p)throw new Error("THREE.EXRLoader: hufDecode issues");let P;for(P=0;P<N.lit;P++){let D=Ae(a[N.p[P]]);for(;S<D&&g.value<I;)Ne(E,S,h,g),E=me.c,S=me.lc;if(S>=D&&bn(a[N.p[P]])==(E>>S-D&(1<<D)-1)){S-=D,De(N.p[P],b,E,S,h,g,k,x,T),E=Ee.c,S=Ee.lc;break}}if(P==N.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let M=8-v&7;for(E>>=M,S-=M;S>0;){let F=u[E<<14-S&16383];if(F.len)S-=F.len,De(F.lit,b,E,S,h,g,k,x,T),E=Ee.c,S=Ee.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function Vt(a,u,h,g,v,b){let m={value:0},k=h.value,x=he(u,h),E=he(u,h);h.value+=4;let S=he(u,h);if(h.value+=4,x<0||x>=65537||E<0||E>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let T=new Array(65537),I=new Array(16384);br(I);let M=g-(h.value-k);if(xn(a,h,M,x,E,T),S>8*(g-(h.value-k)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");Ar(T,x,E,I),En(T,I,a,h,S,E,b,v,m)}function ma(a,u,h){for(let g=0;g<h;++g)u[g]=a[u[g]]}function Rn(a){for(let u=1;u<a.length;u++){let h=a[u-1]+a[u]-128;a[u]=h}}function kn(a,u){let h=0,g=Math.floor((a.length+1)/2),v=0,b=a.length-1;for(;!(v>b||(u[v++]=a[h++],v>b));)u[v++]=a[g++]}function Er(a){let u=a.byteLength,h=new Array,g=0,v=new DataView(a);for(;u>0;){let b=v.getInt8(g++);if(b<0){let m=-b;u-=m+1;for(let k=0;k<m;k++)h.push(v.getUint8(g++))}else{let m=b;u-=2;let k=v.getUint8(g++);for(let x=0;x<m+1;x++)h.push(k)}}return h}function ga(a,u,h,g,v,b){let m=new DataView(b.buffer),k=h[a.idx[0]].width,x=h[a.idx[0]].height,E=3,S=Math.floor(k/8),T=Math.ceil(k/8),I=Math.ceil(x/8),M=k-(T-1)*8,F=x-(I-1)*8,N={value:0},P=new Array(E),D=new Array(E),q=new Array(E),B=new Array(E),Y=new Array(E);for(let C=0;C<E;++C)Y[C]=u[a.idx[C]],P[C]=C<1?0:P[C-1]+T*I,D[C]=new Float32Array(64),q[C]=new Uint16Array(64),B[C]=new Uint16Array(T*64);for(let C=0;C<I;++C){let U=8;C==I-1&&(U=F);let X=8;for(let $=0;$<T;++$){$==T-1&&(X=M);for(let j=0;j<E;++j)q[j].fill(0),q[j][0]=v[P[j]++],Os(N,g,q[j]),Ms(q[j],D[j]),Ls(D[j]);E==3&&va(D);for(let j=0;j<E;++j)Cs(D[j],B[j],$*64)}let W=0;for(let $=0;$<E;++$){let j=h[a.idx[$]].type;for(let te=8*C;te<8*C+U;++te){W=Y[$][te];for(let pe=0;pe<S;++pe){let ee=pe*64+(te&7)*8;m.setUint16(W+0*j,B[$][ee+0],!0),m.setUint16(W+2*j,B[$][ee+1],!0),m.setUint16(W+4*j,B[$][ee+2],!0),m.setUint16(W+6*j,B[$][ee+3],!0),m.setUint16(W+8*j,B[$][ee+4],!0),m.setUint16(W+10*j,B[$][ee+5],!0),m.setUint16(W+12*j,B[$][ee+6],!0),m.setUint16(W+14*j,B[$][ee+7],!0),W+=16*j}}if(S!=T)for(let te=8*C;te<8*C+U;++te){let pe=Y[$][te]+8*S*2*j,ee=S*64+(te&7)*8;for(let Oe=0;Oe<X;++Oe)m.setUint16(pe+Oe*2*j,B[$][ee+Oe],!0)}}}let z=new Uint16Array(k);m=new DataView(b.buffer);for(let C=0;C<E;++C){h[a.idx[C]].decoded=!0;let U=h[a.idx[C]].type;if(h[C].type==2)for(let X=0;X<x;++X){let W=Y[C][X];for(let $=0;$<k;++$)z[$]=m.getUint16(W+$*2*U,!0);for(let $=0;$<k;++$)m.setFloat32(W+$*2*U,O.fromHalfFloat(z[$]),!0)}}}function _a(a,u,h,g,v,b){let m=new DataView(b.buffer),k=h[a],x=k.width,E=k.height,S=Math.ceil(x/8),T=Math.ceil(E/8),I=Math.floor(x/8),M=x-(S-1)*8,F=E-(T-1)*8,N={value:0},P=0,D=new Float32Array(64),q=new Uint16Array(64),B=new Uint16Array(S*64);for(let Y=0;Y<T;++Y){let z=8;Y==T-1&&(z=F);for(let C=0;C<S;++C)q.fill(0),q[0]=v[P++],Os(N,g,q),Ms(q,D),Ls(D),Cs(D,B,C*64);for(let C=8*Y;C<8*Y+z;++C){let U=u[a][C];for(let X=0;X<I;++X){let W=X*64+(C&7)*8;for(let $=0;$<8;++$)m.setUint16(U+$*2*k.type,B[W+$],!0);U+=16*k.type}if(S!=I){let X=I*64+(C&7)*8;for(let W=0;W<M;++W)m.setUint16(U+W*2*k.type,B[X+W],!0)}}}k.decoded=!0}function Os(a,u,h){let g,v=1;for(;v<64;)g=u[a.value],g==65280?v=64:g>>8==255?v+=g&255:(h[v]=g,v++),a.value++}function Ms(a,u){u[0]=O.fromHalfFloat(a[0]),u[1]=O.fromHalfFloat(a[1]),u[2]=O.fromHalfFloat(a[5]),u[3]=O.fromHalfFloat(a[6]),u[4]=O.fromHalfFloat(a[14]),u[5]=O.fromHalfFloat(a[15]),u[6]=O.fromHalfFloat(a[27]),u[7]=O.fromHalfFloat(a[28]),u[8]=O.fromHalfFloat(a[2]),u[9]=O.fromHalfFloat(a[4]),u[10]=O.fromHalfFloat(a[7]),u[11]=O.fromHalfFloat(a[13]),u[12]=O.fromHalfFloat(a[16]),u[13]=O.fromHalfFloat(a[26]),u[14]=O.fromHalfFloat(a[29]),u[15]=O.fromHalfFloat(a[42]),u[16]=O.fromHalfFloat(a[3]),u[17]=O.fromHalfFloat(a[8]),u[18]=O.fromHalfFloat(a[12]),u[19]=O.fromHalfFloat(a[17]),u[20]=O.fromHalfFloat(a[25]),u[21]=O.fromHalfFloat(a[30]),u[22]=O.fromHalfFloat(a[41]),u[23]=O.fromHalfFloat(a[43]),u[24]=O.fromHalfFloat(a[9]),u[25]=O.fromHalfFloat(a[11]),u[26]=O.fromHalfFloat(a[18]),u[27]=O.fromHalfFloat(a[24]),u[28]=O.fromHalfFloat(a[31]),u[29]=O.fromHalfFloat(a[40]),u[30]=O.fromHalfFloat(a[44]),u[31]=O.fromHalfFloat(a[53]),u[32]=O.fromHalfFloat(a[10]),u[33]=O.fromHalfFloat(a[19]),u[34]=O.fromHalfFloat(a[23]),u[35]=O.fromHalfFloat(a[32]),u[36]=O.fromHalfFloat(a[39]),u[37]=O.fromHalfFloat(a[45]),u[38]=O.fromHalfFloat(a[52]),u[39]=O.fromHalfFloat(a[54]),u[40]=O.fromHalfFloat(a[20]),u[41]=O.fromHalfFloat(a[22]),u[42]=O.fromHalfFloat(a[33]),u[43]=O.fromHalfFloat(a[38]),u[44]=O.fromHalfFloat(a[46]),u[45]=O.fromHalfFloat(a[51]),u[46]=O.fromHalfFloat(a[55]),u[47]=O.fromHalfFloat(a[60]),u[48]=O.fromHalfFloat(a[21]),u[49]=O.fromHalfFloat(a[34]),u[50]=O.fromHalfFloat(a[37]),u[51]=O.fromHalfFloat(a[47]),u[52]=O.fromHalfFloat(a[50]),u[53]=O.fromHalfFloat(a[56]),u[54]=O.fromHalfFloat(a[59]),u[55]=O.fromHalfFloat(a[61]),u[56]=O.fromHalfFloat(a[35]),u[57]=O.fromHalfFloat(a[36]),u[58]=O.fromHalfFloat(a[48]),u[59]=O.fromHalfFloat(a[49]),u[60]=O.fromHalfFloat(a[57]),u[61]=O.fromHalfFloat(a[58]),u[62]=O.fromHalfFloat(a[62]),u[63]=O.fromHalfFloat(a[63])}function Ls(a){let u=.5*Math.cos(.7853975),h=.5*Math.cos(3.14159/16),g=.5*Math.cos(3.14159/8),v=.5*Math.cos(3*3.14159/16),b=.5*Math.cos(5*3.14159/16),m=.5*Math.cos(3*3.14159/8),k=.5*Math.cos(7*3.14159/16),x=new Array(4),E=new Array(4),S=new Array(4),T=new Array(4);for(let I=0;I<8;++I){let M=I*8;x[0]=g*a[M+2],x[1]=m*a[M+2],x[2]=g*a[M+6],x[3]=m*a[M+6],E[0]=h*a[M+1]+v*a[M+3]+b*a[M+5]+k*a[M+7],E[1]=v*a[M+1]-k*a[M+3]-h*a[M+5]-b*a[M+7],E[2]=b*a[M+1]-h*a[M+3]+k*a[M+5]+v*a[M+7],E[3]=k*a[M+1]-b*a[M+3]+v*a[M+5]-h*a[M+7],S[0]=u*(a[M+0]+a[M+4]),S[3]=u*(a[M+0]-a[M+4]),S[1]=x[0]+x[3],S[2]=x[1]-x[2],T[0]=S[0]+S[1],T[1]=S[3]+S[2],T[2]=S[3]-S[2],T[3]=S[0]-S[1],a[M+0]=T[0]+E[0],a[M+1]=T[1]+E[1],a[M+2]=T[2]+E[2],a[M+3]=T[3]+E[3],a[M+4]=T[3]-E[3],a[M+5]=T[2]-E[2],a[M+6]=T[1]-E[1],a[M+7]=T[0]-E[0]}for(let I=0;I<8;++I)x[0]=g*a[16+I],x[1]=m*a[16+I],x[2]=g*a[48+I],x[3]=m*a[48+I],E[0]=h*a[8+I]+v*a[24+I]+b*a[40+I]+k*a[56+I],E[1]=v*a[8+I]-k*a[24+I]-h*a[40+I]-b*a[56+I],E[2]=b*a[8+I]-h*a[24+I]+k*a[40+I]+v*a[56+I],E[3]=k*a[8+I]-b*a[24+I]+v*a[40+I]-h*a[56+I],S[0]=u*(a[I]+a[32+I]),S[3]=u*(a[I]-a[32+I]),S[1]=x[0]+x[3],S[2]=x[1]-x[2],T[0]=S[0]+S[1],T[1]=S[3]+S[2],T[2]=S[3]-S[2],T[3]=S[0]-S[1],a[0+I]=T[0]+E[0],a[8+I]=T[1]+E[1],a[16+I]=T[2]+E[2],a[24+I]=T[3]+E[3],a[32+I]=T[3]-E[3],a[40+I]=T[2]-E[2],a[48+I]=T[1]-E[1],a[56+I]=T[0]-E[0]}function va(a){for(let u=0;u<64;++u){let h=a[0][u],g=a[1][u],v=a[2][u];a[0][u]=h+1.5747*v,a[1][u]=h-.1873*g-.4682*v,a[2][u]=h+1.8556*g}}let Rr=new Float32Array(1),Ps=new Uint32Array(Rr.buffer);function Fs(a){Rr[0]=a;let u=Ps[0],h=u>>>16&32768,g=u&2147483647;if(g>=1199570944)return h|(g>2139095040?32256:31744);if(g<947912704)return Rr[0]=Math.abs(a)+.5,h|Ps[0]-1056964608;let v=g+4095+(g>>>13&1);return h|v-939524096>>>13}function Cs(a,u,h){if(se===null){se=new Uint16Array(65536);for(let g=1;g<65536;++g){if((g&31744)===31744)continue;let v=O.fromHalfFloat(g),b=Math.abs(v),m=b<=1?Math.pow(b,2.2):Math.pow(lt,b-1);se[g]=Fs(v<0?-m:m)}}for(let g=0;g<64;++g)u[h+g]=se[Fs(a[g])]}function Sn(a){return new DataView(a.array.buffer,a.offset.value,a.size)}function ya(a){let u=a.viewer.buffer.slice(a.offset.value,a.offset.value+a.size),h=new Uint8Array(Er(u)),g=new Uint8Array(h.length);return Rn(h),kn(h,g),new DataView(g.buffer)}function kr(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),h=Ft(u),g=new Uint8Array(h.length);return Rn(h),kn(h,g),new DataView(g.buffer)}function wa(a){let u=a.viewer,h={value:a.offset.value},g=new Uint16Array(a.columns*a.lines*(a.inputChannels.length*a.type)),v=new Uint8Array(8192),b=0,m=new Array(a.inputChannels.length);for(let F=0,N=a.inputChannels.length;F<N;F++)m[F]={},m[F].start=b,m[F].end=m[F].start,m[F].nx=a.columns,m[F].ny=a.lines,m[F].size=a.type,b+=m[F].nx*m[F].ny*m[F].size;let k=Kt(u,h),x=Kt(u,h);if(x>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(k<=x)for(let F=0;F<x-k+1;F++)v[F+k]=We(u,h);let E=new Uint16Array(65536),S=wn(v,E),T=he(u,h);Vt(a.array,u,h,T,g,b);for(let F=0;F<a.inputChannels.length;++F){let N=m[F];for(let P=0;P<m[F].size;++P)An(g,N.start+P,N.nx,N.size,N.ny,N.nx*N.size,S)}ma(E,g,b);let I=0,M=new Uint8Array(g.buffer.byteLength);for(let F=0;F<a.lines;F++)for(let N=0;N<a.inputChannels.length;N++){let P=m[N],D=P.nx*P.size,q=new Uint8Array(g.buffer,P.end*2,D*2);M.set(q,I),I+=D*2,P.end+=D}return new DataView(M.buffer)}function xa(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),h=Ft(u),g=a.inputChannels.length*a.lines*a.columns*a.totalBytes,v=new ArrayBuffer(g),b=new DataView(v),m=0,k=0,x=new Array(4);for(let E=0;E<a.lines;E++)for(let S=0;S<a.inputChannels.length;S++){let T=0;switch(a.inputChannels[S].pixelType){case 1:x[0]=m,x[1]=x[0]+a.columns,m=x[1]+a.columns;for(let M=0;M<a.columns;++M){let F=h[x[0]++]<<8|h[x[1]++];T+=F,b.setUint16(k,T,!0),k+=2}break;case 2:x[0]=m,x[1]=x[0]+a.columns,x[2]=x[1]+a.columns,m=x[2]+a.columns;for(let M=0;M<a.columns;++M){let F=h[x[0]++]<<24|h[x[1]++]<<16|h[x[2]++]<<8;T+=F,b.setUint32(k,T,!0),k+=4}break}}return b}function ba(a){let u=a.array,h=a.offset.value,g=a.columns,v=a.lines,b=a.inputChannels,m=a.totalBytes,k=oe.compression==="B44A_COMPRESSION",x=new Uint8Array(v*g*m),E=new Uint16Array(16),S=0;for(let T=0;T<b.length;T++){let I=b[T],M=I.pixelType*2,F=Math.ceil(g/I.xSampling),N=Math.ceil(v/I.ySampling),P=I.xSampling===1&&I.ySampling===1;if(I.pixelType!==1){for(let B=0;B<N;B++)if(P){let Y=B*g*m+S*g;for(let z=0;z<F*M;z++)x[Y+z]=u[h++]}else h+=F*M;S+=M;continue}let D=Math.ceil(F/4),q=Math.ceil(N/4);for(let B=0;B<q;B++)for(let Y=0;Y<D;Y++){if(k&&u[h+2]>=52){let z=u[h]<<8|u[h+1],C=z&32768?z&32767:~z&65535;E.fill(C),h+=3}else{let z=u[h]<<8|u[h+1],C=u[h+2]>>2,U=32<<C,X=z+((u[h+2]<<4|u[h+3]>>4)&63)*(1<<C)-U&65535,W=X+((u[h+3]<<2|u[h+4]>>6)&63)*(1<<C)-U&65535,$=W+(u[h+4]&63)*(1<<C)-U&65535,j=z+(u[h+5]>>2&63)*(1<<C)-U&65535,te=X+((u[h+5]<<4|u[h+6]>>4)&63)*(1<<C)-U&65535,pe=W+((u[h+6]<<2|u[h+7]>>6)&63)*(1<<C)-U&65535,ee=$+(u[h+7]&63)*(1<<C)-U&65535,Oe=j+(u[h+8]>>2&63)*(1<<C)-U&65535,bt=te+((u[h+8]<<4|u[h+9]>>4)&63)*(1<<C)-U&65535,Xt=pe+((u[h+9]<<2|u[h+10]>>6)&63)*(1<<C)-U&65535,Me=ee+(u[h+10]&63)*(1<<C)-U&65535,ft=Oe+(u[h+11]>>2&63)*(1<<C)-U&65535,Mn=bt+((u[h+11]<<4|u[h+12]>>4)&63)*(1<<C)-U&65535,Ln=Xt+((u[h+12]<<2|u[h+13]>>6)&63)*(1<<C)-U&65535,Pn=Me+(u[h+13]&63)*(1<<C)-U&65535,Jt=[z,j,Oe,ft,X,te,bt,Mn,W,pe,Xt,Ln,$,ee,Me,Pn];for(let At=0;At<16;At++)E[At]=Jt[At]&32768?Jt[At]&32767:~Jt[At]&65535;h+=14}if(I.pLinear){if(Ue===null){Ue=new Uint16Array(65536);for(let z=0;z<65536;z++)if((z&31744)===31744||z>32768)Ue[z]=0;else{let C=O.fromHalfFloat(z);Ue[z]=C<=0?0:O.toHalfFloat(8*Math.log(C))}}for(let z=0;z<16;z++)E[z]=Ue[E[z]]}for(let z=0;z<4;z++){let C=B*4+z;if(!(C>=N))for(let U=0;U<4;U++){let X=Y*4+U;if(X>=F)continue;let W=E[z*4+U];for(let $=0;$<I.ySampling;$++){let j=C*I.ySampling+$;if(!(j>=v))for(let te=0;te<I.xSampling;te++){let pe=X*I.xSampling+te;if(pe>=g)continue;let ee=j*g*m+S*g+pe*2;x[ee]=W&255,x[ee+1]=W>>8&255}}}}}S+=2}return new DataView(x.buffer)}function zs(a){let u=a.viewer,h={value:a.offset.value},g=new Uint8Array(a.columns*a.lines*(a.inputChannels.length*a.type*2)),v={version:re(u,h),unknownUncompressedSize:re(u,h),unknownCompressedSize:re(u,h),acCompressedSize:re(u,h),dcCompressedSize:re(u,h),rleCompressedSize:re(u,h),rleUncompressedSize:re(u,h),rleRawSize:re(u,h),totalAcUncompressedCount:re(u,h),totalDcUncompressedCount:re(u,h),acCompression:re(u,h)};if(v.version<2)throw new Error("THREE.EXRLoader: "+oe.compression+" version "+v.version+" is unsupported");let b=new Array,m=Kt(u,h)-2;for(;m>0;){let N=In(u.buffer,h),P=We(u,h),D=P>>2&3,q=(P>>4)-1,B=new Int8Array([q])[0],Y=We(u,h);b.push({name:N,index:B,type:Y,compression:D}),m-=N.length+3}let k=oe.channels,x=new Array(a.inputChannels.length);for(let N=0;N<a.inputChannels.length;++N){let P=x[N]={},D=k[N];P.name=D.name,P.compression=0,P.decoded=!1,P.type=D.pixelType,P.pLinear=D.pLinear,P.width=a.columns,P.height=a.lines}let E={idx:new Array(3)};for(let N=0;N<a.inputChannels.length;++N){let P=x[N],D=P.name.lastIndexOf("."),q=D>=0?P.name.substring(D+1):P.name;for(let B=0;B<b.length;++B){let Y=b[B];q===Y.name&&P.type===Y.type&&(P.compression=Y.compression,Y.index>=0&&(E.idx[Y.index]=N),P.offset=N)}}let S,T,I;if(v.acCompressedSize>0)switch(v.acCompression){case 0:S=new Uint16Array(v.totalAcUncompressedCount),Vt(a.array,u,h,v.acCompressedSize,S,v.totalAcUncompressedCount);break;case 1:let N=a.array.slice(h.value,h.value+v.totalAcUncompressedCount),P=Ft(N);S=new Uint16Array(P.buffer),h.value+=v.totalAcUncompressedCount;break}if(v.dcCompressedSize>0){let N={array:a.array,offset:h,size:v.dcCompressedSize};T=new Uint16Array(kr(N).buffer),h.value+=v.dcCompressedSize}if(v.rleRawSize>0){let N=a.array.slice(h.value,h.value+v.rleCompressedSize),P=Ft(N);I=Er(P.buffer),h.value+=v.rleCompressedSize}let M=0,F=new Array(x.length);for(let N=0;N<F.length;++N)F[N]=new Array;for(let N=0;N<a.lines;++N)for(let P=0;P<x.length;++P)F[P].push(M),M+=x[P].width*a.type*2;E.idx[0]!==void 0&&x[E.idx[0]]&&ga(E,F,x,S,T,g);for(let N=0;N<x.length;++N){let P=x[N];if(!P.decoded)switch(P.compression){case 2:let D=0,q=0;for(let B=0;B<a.lines;++B){let Y=F[N][D];for(let z=0;z<P.width;++z){for(let C=0;C<2*P.type;++C)g[Y++]=I[q+C*P.width*P.height];q++}D++}break;case 1:_a(N,F,x,S,T,g);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(g.buffer)}function In(a,u){let h=new Uint8Array(a),g=0;for(;h[u.value+g]!=0;)g+=1;let v=new TextDecoder().decode(h.slice(u.value,u.value+g));return u.value=u.value+g+1,v}function Aa(a,u,h){let g=new TextDecoder().decode(new Uint8Array(a).slice(u.value,u.value+h));return u.value=u.value+h,g}function Ea(a,u){let h=le(a,u),g=he(a,u);return[h,g]}function Ra(a,u){let h=he(a,u),g=he(a,u);return[h,g]}function le(a,u){let h=a.getInt32(u.value,!0);return u.value=u.value+4,h}function he(a,u){let h=a.getUint32(u.value,!0);return u.value=u.value+4,h}function Us(a,u){let h=a[u.value];return u.value=u.value+1,h}function We(a,u){let h=a.getUint8(u.value);return u.value=u.value+1,h}let re=function(a,u){let h=Number(a.getBigInt64(u.value,!0));return u.value+=8,h};function ie(a,u){let h=a.getFloat32(u.value,!0);return u.value+=4,h}function ka(a,u){return O.toHalfFloat(ie(a,u))}function Kt(a,u){let h=a.getUint16(u.value,!0);return u.value+=2,h}function Sa(a,u){return O.fromHalfFloat(Kt(a,u))}function Ia(a,u,h,g){let v=h.value,b=[];for(;h.value<v+g-1;){let m=In(u,h),k=le(a,h),x=We(a,h);h.value+=3;let E=le(a,h),S=le(a,h);b.push({name:m,pixelType:k,pLinear:x,xSampling:E,ySampling:S})}return h.value+=1,b}function Ta(a,u){let h=ie(a,u),g=ie(a,u),v=ie(a,u),b=ie(a,u),m=ie(a,u),k=ie(a,u),x=ie(a,u),E=ie(a,u);return{redX:h,redY:g,greenX:v,greenY:b,blueX:m,blueY:k,whiteX:x,whiteY:E}}function Na(a,u){let h=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],g=We(a,u);return h[g]}function Oa(a,u){let h=le(a,u),g=le(a,u),v=le(a,u),b=le(a,u);return{xMin:h,yMin:g,xMax:v,yMax:b}}function Ma(a,u){let h=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],g=We(a,u);return h[g]}function La(a,u){let h=["ENVMAP_LATLONG","ENVMAP_CUBE"],g=We(a,u);return h[g]}function Pa(a,u){let h=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],g=["ROUND_DOWN","ROUND_UP"],v=he(a,u),b=he(a,u),m=We(a,u);return{xSize:v,ySize:b,levelMode:h[m&15],roundingMode:g[m>>4]}}function Fa(a,u){let h=ie(a,u),g=ie(a,u);return[h,g]}function Ca(a,u){let h=ie(a,u),g=ie(a,u),v=ie(a,u);return[h,g,v]}function za(a,u,h,g,v){if(g==="string"||g==="stringvector"||g==="iccProfile")return Aa(u,h,v);if(g==="chlist")return Ia(a,u,h,v);if(g==="chromaticities")return Ta(a,h);if(g==="compression")return Na(a,h);if(g==="box2i")return Oa(a,h);if(g==="envmap")return La(a,h);if(g==="tiledesc")return Pa(a,h);if(g==="lineOrder")return Ma(a,h);if(g==="float")return ie(a,h);if(g==="v2f")return Fa(a,h);if(g==="v3f")return Ca(a,h);if(g==="int")return le(a,h);if(g==="rational")return Ea(a,h);if(g==="timecode")return Ra(a,h);if(g==="preview"||g==="deepImageState"||g==="idmanifest")return h.value+=v,"skipped";h.value+=v}function Ua(a,u){let h=Math.log2(a);return u=="ROUND_DOWN"?Math.floor(h):Math.ceil(h)}function Da(a,u,h){let g=0;switch(a.levelMode){case"ONE_LEVEL":g=1;break;case"MIPMAP_LEVELS":g=Ua(Math.max(u,h),a.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return g}function Ds(a,u,h,g){let v=new Array(a);for(let b=0;b<a;b++){let m=1<<b,k=u/m|0;g=="ROUND_UP"&&k*m<u&&(k+=1);let x=Math.max(k,1);v[b]=(x+h-1)/h|0}return v}function Ha(){let a=this,u=a.offset,h={value:0};for(let g=0;g<a.tileCount;g++){let v=le(a.viewer,u),b=le(a.viewer,u);u.value+=8,a.size=he(a.viewer,u);let m=v*a.blockWidth,k=b*a.blockHeight;a.columns=m+a.blockWidth>a.width?a.width-m:a.blockWidth,a.lines=k+a.blockHeight>a.height?a.height-k:a.blockHeight;let x=a.columns*a.totalBytes,S=a.size<a.lines*x?a.uncompress(a):Sn(a);u.value+=a.size;for(let T=0;T<a.lines;T++){let I=T*a.columns*a.totalBytes;for(let M=0;M<a.inputChannels.length;M++){let F=oe.channels[M].name,N=a.channelByteOffsets[F]*a.columns,P=a.decodeChannels[F];if(P===void 0)continue;h.value=I+N;let D=(a.height-(1+k+T))*a.outLineWidth;for(let q=0;q<a.columns;q++){let B=D+(q+m)*a.outputChannels+P;a.byteArray[B]=a.getter(S,h)}}}}}function Ba(){let a=this,u=a.offset,h={value:0};for(let g=0;g<a.height/a.blockHeight;g++){let v=le(a.viewer,u)-oe.dataWindow.yMin;a.size=he(a.viewer,u),a.lines=v+a.blockHeight>a.height?a.height-v:a.blockHeight;let b=a.columns*a.totalBytes,k=a.size<a.lines*b?a.uncompress(a):Sn(a);u.value+=a.size;for(let x=0;x<a.lines;x++){let E=v+x,S=x*b,T=(a.height-1-E)*a.outLineWidth;for(let I=0;I<a.inputChannels.length;I++){let M=oe.channels[I].name,F=a.channelByteOffsets[M]*a.columns,N=a.decodeChannels[M];if(N!==void 0){h.value=S+F;for(let P=0;P<a.columns;P++){let D=T+P*a.outputChannels+N;a.byteArray[D]=a.getter(k,h)}}}}}}function $a(){let a=this,u=a.chunkOffsets,h={value:0};for(let g=0;g<u.length;g++){let v={value:u[g]};v.value+=4;let b=le(a.viewer,v)-oe.dataWindow.yMin;a.size=he(a.viewer,v),a.lines=b+a.blockHeight>a.height?a.height-b:a.blockHeight;let m=a.columns*a.totalBytes,k=a.size<a.lines*m,x=a.offset;a.offset=v;let E=k?a.uncompress(a):Sn(a);a.offset=x;for(let S=0;S<a.lines;S++){let T=b+S,I=S*m,M=(a.height-1-T)*a.outLineWidth;for(let F=0;F<a.inputChannels.length;F++){let N=oe.channels[F].name,P=a.channelByteOffsets[N]*a.columns,D=a.decodeChannels[N];if(D!==void 0){h.value=I+P;for(let q=0;q<a.columns;q++){let B=M+q*a.outputChannels+D;a.byteArray[B]=a.getter(E,h)}}}}}}function Hs(a,u,h,g){if(h===0)return null;let v=a.slice(u,u+h);switch(g){case"NO_COMPRESSION":return new DataView(v.buffer,v.byteOffset,v.byteLength);case"RLE_COMPRESSION":{let b=new Uint8Array(Er(v.buffer.slice(v.byteOffset,v.byteOffset+v.byteLength))),m=new Uint8Array(b.length);return Rn(b),kn(b,m),new DataView(m.buffer)}case"ZIPS_COMPRESSION":{let b=Ft(v),m=new Uint8Array(b.length);return Rn(b),kn(b,m),new DataView(m.buffer)}default:throw new Error("THREE.EXRLoader: "+g+" is unsupported for deep data")}}function Ga(){let a=this,u=a.chunkOffsets,h=a.width,g=a.height,v=a.deepChannels,b=oe.compression,m=a.multiPart,k=a.decodeChannels,x=a.outputChannels,E=a.byteArray instanceof Uint16Array,S=-1;for(let T=0;T<v.length;T++)if(v[T].name==="A"){S=T;break}for(let T=0;T<u.length;T++){let I={value:u[T]};m&&(I.value+=4);let M=le(a.viewer,I)-oe.dataWindow.yMin,F=re(a.viewer,I),N=re(a.viewer,I);re(a.viewer,I);let P=Hs(a.array,I.value,F,b);if(I.value+=F,P===null)continue;let D=new Uint32Array(h);for(let U=0;U<h;U++)D[U]=P.getUint32(U*4,!0);let q=D[h-1];if(q===0){I.value+=N;continue}let B=Hs(a.array,I.value,N,b),Y=[],z=0;for(let U=0;U<v.length;U++)Y.push(z),z+=q*v[U].bytesPerSample;let C=(g-1-M)*a.outLineWidth;for(let U=0;U<h;U++){let X=U===0?0:D[U-1],$=D[U]-X;if($===0)continue;let j=new Float32Array(x),te=0;for(let ee=0;ee<$;ee++){let Oe=X+ee,bt=1-te;if(bt<=0)break;let Xt=1;if(S>=0){let Me=v[S].bytesPerSample,ft=Y[S]+Oe*Me;Xt=Me===2?O.fromHalfFloat(B.getUint16(ft,!0)):B.getFloat32(ft,!0)}for(let Me=0;Me<v.length;Me++){let ft=v[Me],Mn=k[ft.name];if(Mn===void 0)continue;let Ln=ft.bytesPerSample,Pn=Y[Me]+Oe*Ln,Jt=Ln===2?O.fromHalfFloat(B.getUint16(Pn,!0)):B.getFloat32(Pn,!0);j[Mn]+=Jt*bt}te+=Xt*bt}k.A!==void 0&&(j[k.A]=te);let pe=C+U*x;for(let ee=0;ee<x;ee++)a.byteArray[pe+ee]=E?O.toHalfFloat(j[ee]):j[ee]}}}function Bs(a,u,h){let g={},v=!1;for(;;){let b=In(u,h);if(b==="")break;v=!0;let m=In(u,h),k=he(a,h),x=za(a,u,h,m,k);x===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${m}'.`):g[b]=x}return v?g:null}function qa(a,u,h){if(a.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let g=a.getUint8(4),v=a.getUint8(5),b={singleTile:!!(v&2),longName:!!(v&4),deepFormat:!!(v&8),multiPart:!!(v&16)};h.value=8;let m=[];if(b.multiPart){for(;;){let k=Bs(a,u,h);if(k===null)break;k.version=g,k.spec=b,m.push(k)}if(m.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let k=Bs(a,u,h);k.version=g,k.spec=b,m.push(k)}return m}function ja(a,u,h,g,v,b){let m={size:0,viewer:u,array:h,offset:g,width:a.dataWindow.xMax-a.dataWindow.xMin+1,height:a.dataWindow.yMax-a.dataWindow.yMin+1,inputChannels:a.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:Qe};switch(a.compression){case"NO_COMPRESSION":m.blockHeight=1,m.uncompress=Sn;break;case"RLE_COMPRESSION":m.blockHeight=1,m.uncompress=ya;break;case"ZIPS_COMPRESSION":m.blockHeight=1,m.uncompress=kr;break;case"ZIP_COMPRESSION":m.blockHeight=16,m.uncompress=kr;break;case"PIZ_COMPRESSION":m.blockHeight=32,m.uncompress=wa;break;case"PXR24_COMPRESSION":m.blockHeight=16,m.uncompress=xa;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":m.blockHeight=32,m.uncompress=ba;break;case"DWAA_COMPRESSION":m.blockHeight=32,m.uncompress=zs;break;case"DWAB_COMPRESSION":m.blockHeight=256,m.uncompress=zs;break;default:throw new Error("THREE.EXRLoader: "+a.compression+" is unsupported")}let k={};for(let I of a.channels)switch(I.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":k[I.name]=!0,m.type=I.pixelType}let x=!1,E=!1;if(k.Y&&k.RY&&k.BY)m.outputChannels=4,m.yCbCr=!0;else if(k.R&&k.G&&k.B)m.outputChannels=4;else if(k.Y)m.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(m.outputChannels){case 4:b==Je?(x=!k.A,m.format=Je,m.colorSpace=Qe,m.outputChannels=4,m.decodeChannels={R:0,G:1,B:2,A:3}):b==Lt?(m.format=Lt,m.colorSpace=Qe,m.outputChannels=2,m.decodeChannels={R:0,G:1}):b==ln?(m.format=ln,m.colorSpace=Qe,m.outputChannels=1,m.decodeChannels={R:0}):E=!0;break;case 1:b==Je?(x=!0,m.format=Je,m.colorSpace=Qe,m.outputChannels=4,m.shouldExpand=!0,m.decodeChannels={Y:0}):b==Lt?(m.format=Lt,m.colorSpace=Qe,m.outputChannels=2,m.shouldExpand=!0,m.decodeChannels={Y:0}):b==ln?(m.format=ln,m.colorSpace=Qe,m.outputChannels=1,m.decodeChannels={Y:0}):E=!0;break;default:E=!0}if(E)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(m.yCbCr&&(m.format=Je,m.outputChannels=4,m.decodeChannels={Y:0,RY:1,BY:2},x=!0),m.type==1)switch(v){case Ot:m.getter=Sa;break;case Mt:m.getter=Kt;break}else if(m.type==2)switch(v){case Ot:m.getter=ie;break;case Mt:m.getter=ka}else throw new Error("THREE.EXRLoader: unsupported pixelType "+m.type+" for "+a.compression+".");m.columns=m.width;let S=m.width*m.height*m.outputChannels;switch(v){case Ot:m.byteArray=new Float32Array(S),x&&m.byteArray.fill(1,0,S);break;case Mt:m.byteArray=new Uint16Array(S),x&&m.byteArray.fill(15360,0,S);break;default:console.error("THREE.EXRLoader: unsupported type: ",v);break}let T=0;for(let I of a.channels)m.decodeChannels[I.name]!==void 0&&(m.channelByteOffsets[I.name]=T),T+=I.pixelType*2;if(m.totalBytes=T,m.outLineWidth=m.width*m.outputChannels,a.spec.deepFormat){m.deepChannels=[];let I=0;for(let M of a.channels){let F=M.pixelType===0?4:M.pixelType*2;m.deepChannels.push({name:M.name,pixelType:M.pixelType,bytesPerSample:F}),I+=F}m.deepBytesPerSample=I,m.chunkOffsets=a._chunkOffsets,m.multiPart=a.spec.multiPart,m.decode=Ga.bind(m)}else if(a.spec.singleTile){m.blockHeight=a.tiles.ySize,m.blockWidth=a.tiles.xSize;let I=Da(a.tiles,m.width,m.height),M=Ds(I,m.width,a.tiles.xSize,a.tiles.roundingMode),F=Ds(I,m.height,a.tiles.ySize,a.tiles.roundingMode);m.tileCount=M[0]*F[0];for(let N=0;N<I;N++)for(let P=0;P<F[N];P++)for(let D=0;D<M[N];D++)re(u,g);m.decode=Ha.bind(m)}else if(a.spec.multiPart)m.blockWidth=m.width,m.chunkOffsets=a._chunkOffsets,m.decode=$a.bind(m);else{m.blockWidth=m.width;let I=Math.ceil(m.height/m.blockHeight);for(let M=0;M<I;M++)re(u,g);m.decode=Ba.bind(m)}return m}let Tn={value:0},Nn=new DataView(e),Za=new Uint8Array(e),On=qa(Nn,e,Tn),$s=Math.max(0,Math.min(this.part,On.length-1)),oe=On[$s];if(oe.spec.multiPart||oe.spec.deepFormat)for(let a=0;a<On.length;a++){let u=On[a].chunkCount;if(a===$s){oe._chunkOffsets=[];for(let h=0;h<u;h++)oe._chunkOffsets.push(re(Nn,Tn))}else for(let h=0;h<u;h++)re(Nn,Tn)}let ge=ja(oe,Nn,Za,Tn,this.type,this.outputFormat);if(ge.decode(),ge.shouldExpand){let a=ge.byteArray;if(this.outputFormat==Je)for(let u=0;u<a.length;u+=4)a[u+2]=a[u+1]=a[u];else if(this.outputFormat==Lt)for(let u=0;u<a.length;u+=2)a[u+1]=a[u]}if(ge.yCbCr){let a=ge.byteArray,u=ge.width*ge.height;if(this.type===Mt)for(let h=0;h<u;h++){let g=h*4,v=O.fromHalfFloat(a[g]),b=O.fromHalfFloat(a[g+1]),m=O.fromHalfFloat(a[g+2]),k=(1+b)*v,x=(1+m)*v,E=(v-k*.2126-x*.0722)/.7152;a[g]=O.toHalfFloat(Math.max(0,k)),a[g+1]=O.toHalfFloat(Math.max(0,E)),a[g+2]=O.toHalfFloat(Math.max(0,x))}else for(let h=0;h<u;h++){let g=h*4,v=a[g],b=a[g+1],m=a[g+2],k=(1+b)*v,x=(1+m)*v;a[g]=Math.max(0,k),a[g+1]=Math.max(0,(v-k*.2126-x*.0722)/.7152),a[g+2]=Math.max(0,x)}}return{header:oe,width:ge.width,height:ge.height,data:ge.byteArray,format:ge.format,colorSpace:ge.colorSpace,type:this.type,minFilter:Yr,magFilter:Yr,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var Ii=32768,Vc=2**27,Ti=2**28,Ni=1024,Kc=12,Xr=2**29,Oi=1e18;function Xn(r,e,t){let n=Math.max(r,e)>Ii||r*e>Vc;if(Math.min(r,e)<1||n)throw new G(`has ${r} x ${e} pixels; from 1 to ${Ii} a side, 2^27 in all`);let s=r*e*Kc;if(s>Ti&&s>Ni*t)throw new G(`has ${r} x ${e} pixels in ${t} bytes; an image above ${Ti} bytes of radiance is at most ${Ni} times its file`)}var Xc=512,Jc=2048,Qc=4096,Qn=["NO","RLE","ZIPS","ZIP","PIZ","PXR24","B44","B44A","DWAA","DWAB"],el=0,tl=2,nl=2,rl=4096,Mi=["RY","BY"];function Li(r){let{parts:e,flags:t}=ll(r),n=il(e),s=e[n];ol(s,e.length,t);for(let Z of[s.dataWindow,s.displayWindow])Xn(...Jn(Z),r.length);let i=e.reduce((Z,K)=>Z+Math.max(0,sl(K)),0);if(i>Xr)throw new G(`has ${i} values in all its channels; at most ${Xr}`);let o=s.dataWindow,c=s.displayWindow,l=Math.max(o[0],c[0]),f=Math.min(o[2],c[2]),p=Math.max(o[1],c[1]),d=Math.min(o[3],c[3]);if(l>f||p>d)throw new G("its data window lies outside its display window");al(s);let w=new Kn().setDataType(Ot).setPart(n).parse(cl(r,s).buffer),[A,R]=Jn(c),[L]=Jn(o),H=new Float32Array(3*A*R);for(let Z=p;Z<=d;Z++){let K=o[3]-Z;for(let Q=l;Q<=f;Q++){let xe=4*(K*L+Q-o[0]),Te=3*((Z-c[1])*A+Q-c[0]);for(let Ze=0;Ze<3;Ze++)H[Te+Ze]=w.data[xe+Ze]}}return{rgb:H,width:A,height:R}}function Jn([r,e,t,n]){return[t-r+1,n-e+1]}function sl({dataWindow:r,channels:e}){let[t,n]=Jn(r);return Math.max(0,t)*Math.max(0,n)*e.length}function Qr({channels:r}){let e=new Set(r.map(({name:t})=>t));return e.has("R")&&e.has("G")&&e.has("B")?["R","G","B"]:e.has("Y")&&!Mi.some(t=>e.has(t))?["Y"]:[]}function il(r){let e=r.findIndex(s=>Qr(s).length>0);if(e>=0)return e;let t=[...new Set(r.flatMap(({channels:s})=>s.map(({name:i})=>i)))].sort();if(["Y",...Mi].every(s=>t.includes(s)))throw new G("has luminance and chroma (Y, RY, BY): save it with R, G and B");let n=t.length>12?` and ${t.length-12} more`:"";throw new G(`has no channels R, G and B, nor Y; it has ${t.slice(0,12).join(", ")||"none"}${n}`)}function ol(r,e,t){let n=r.type?r.type.startsWith("deep"):(t&Jc)!==0,s=r.type?r.type==="tiledimage":(t&Xc)!==0,i=o=>{throw new G(o)};n&&i("is a deep image, with any number of samples a pixel: flatten it"),r.envmap&&i("is a cube map: convert it to latitude and longitude"),r.channels.some(({x:o,y:c})=>o!==1||c!==1)&&i("has channels of fewer texels than others: save them all at full size"),Qn[r.compression]===void 0&&i(`has compression ${r.compression}, expected one of ${Qn.join(", ")}`),s&&e>1&&i("has tiles in one of several parts: save it with scan lines"),s&&r.levels===nl&&i("has tiles of several sizes by row and column: save it with one size")}function al(r){let e=Qr(r),t=new Set;for(let{name:n,type:s}of r.channels)e.includes(n)&&t.add(["uint32","float16","float32"][s]);if(t.size>1||t.has("uint32"))throw new G(`has colours of type ${[...t].sort().join(", ")}, expected float16 or float32`)}function cl(r,e){let t=r.slice(),n=Qr(e),s=e.channels.find(({name:o})=>o===n[0]).type,i=["DWAA","DWAB"].includes(Qn[e.compression]);for(let o of e.channels)if(o.type===el&&Qn[e.compression]!=="PXR24"&&(t[o.typeAt]=tl),["A","Y","RY","BY"].includes(o.name)&&!n.includes(o.name)&&!(i&&o.type===s))for(let l=0;l<o.name.length;l++)t[o.at+l]|=32;return t}function ll(r){let e=new DataView(r.buffer,r.byteOffset,r.length),t=e.getUint32(4,!0),n={bytes:r,view:e,at:8},s=[];do{let i=ul(n);if(i===null)break;s.push(i)}while(t&Qc);if(!s.length)throw new G("broken EXR image: it has no header");return{parts:s,flags:t}}function ul(r){let e={channels:null,compression:null,dataWindow:null,displayWindow:null,type:"",envmap:0,levels:0},{view:t}=r;for(let s=0;;s++){let i=Jr(r);if(i===""){if(s===0)return null;break}let o=Jr(r),c=t.getInt32(r.at,!0),l=r.at+4;if(c<0||l+c>r.bytes.length||s>rl)throw new G("broken EXR image: an attribute goes past the file's end");i==="channels"&&(e.channels=fl({...r,at:l})),i==="compression"&&(e.compression=t.getUint8(l)),(i==="dataWindow"||i==="displayWindow")&&(e[i]=[0,4,8,12].map(f=>t.getInt32(l+f,!0))),i==="type"&&(e.type=String.fromCharCode(...r.bytes.subarray(l,l+Math.min(c,64)))),i==="envmap"&&o==="envmap"&&(e.envmap=t.getUint8(l)),i==="tiles"&&(e.levels=t.getUint8(l+8)&15),r.at=l+c}let n=["channels","compression","dataWindow","displayWindow"].find(s=>e[s]===null);if(n!==void 0)throw new G(`broken EXR image: it has no ${n}`);return e}function fl(r){let e=[];for(;;){let t=r.at,n=Jr(r);if(n==="")return e;let s=r.at,{view:i}=r;e.push({name:n,at:t,typeAt:s,type:i.getInt32(s,!0),x:i.getInt32(s+8,!0),y:i.getInt32(s+12,!0)}),r.at+=16}}function Jr(r){let e=r.bytes.indexOf(0,r.at);if(e<0||e-r.at>255)throw new G("broken EXR image: its header does not end");let t=new TextDecoder("utf-8",{fatal:!0}).decode(r.bytes.subarray(r.at,e));return r.at=e+1,t}var hl=65536,Pi=[8,32767],pl=/^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/,dl=/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/,es=/^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g,we=r=>new G(`broken HDR image${r}`);function Fi(r){let e=ml(r),{count:t,length:n,columns:s,back:i,exposure:o}=e,c=gl(r,e),l=1/o,[f,p]=s?[t,n]:[n,t],d=new Float32Array(3*f*p);for(let _=0;_<t;_++){let w=i[0]?t-1-_:_;for(let A=0;A<n;A++){let R=i[1]?n-1-A:A,L=4*(_*n+A),H=3*(s?R*f+w:w*f+R),Z=c[L+3],K=Z>0?l*2**(Z-136):0;for(let Q=0;Q<3;Q++)d[H+Q]=c[L+Q]*K}}return{rgb:d,width:f,height:p}}function ml(r){let e=[],t=0,n=-1;for(;n<0||e.length<n+2;){let d=r.subarray(0,hl).indexOf(10,t);if(d<0)throw we(": it has no header");e.push(Array.from(r.subarray(t,d),_=>String.fromCharCode(_)).join("")),t=d+1,n<0&&e.at(-1).replace(/\r+$/,"")===""&&(n=e.length-1)}let s=1;for(let d of e.slice(1,n)){let _=d.indexOf("="),[w,A]=_<0?[d,""]:[d.slice(0,_),d.slice(_+1)],R=w.replace(es,""),L=A.replace(es,"");if(R==="FORMAT"&&L!=="32-bit_rle_rgbe")throw we(`: format '${L}', expected 32-bit_rle_rgbe`);R==="EXPOSURE"&&(s*=dl.test(L)?Number(L)||1:0)}if(!(s>0&&s<1/0))throw we(": EXPOSURE is not a positive number");let i=e[n+1].replace(es,""),o=pl.exec(i);if(o===null||o[2]===o[5])throw we(`: size '${i.slice(0,40)}', expected such as '-Y height +X width'`);let c=Number(o[3]),l=Number(o[6]),f=o[2]==="X",p=[o[1]+o[2],o[4]+o[5]].map(d=>d==="+Y"||d==="-X");return Xn(...f?[c,l]:[l,c],r.length),{offset:t,count:c,length:l,columns:f,back:p,exposure:s}}function gl(r,{offset:e,count:t,length:n}){let s=new Uint8Array(4*t*n),i=e;try{for(let o=0;o<t;o++)i=_l(r,i,s.subarray(4*o*n),n,o)}catch(o){if(r.length-e===s.length)return r.subarray(e);throw o}return s}function _l(r,e,t,n,s){if(n>=Pi[0]&&n<=Pi[1]&&e+4<=r.length&&r[e]===2&&r[e+1]===2&&r[e+2]<128){if(r[e+2]*256+r[e+3]!==n)throw we(`, line ${s}: a run goes past the line's end`);return vl(r,e+4,t,n,s)}return yl(r,e,t,n,s)}function vl(r,e,t,n,s){for(let i=0;i<4;i++)for(let o=0;o<n;){if(e+2>r.length)throw we(`, line ${s}: the file ends there`);let c=r[e]>128,l=c?r[e]-128:r[e];if(l===0)throw we(`, line ${s}: a run of no pixels`);if(o+l>n)throw we(`, line ${s}: a run goes past the line's end`);if(e+1+(c?1:l)>r.length)throw we(`, line ${s}: the file ends there`);for(let f=0;f<l;f++)t[4*(o+f)+i]=r[e+1+(c?0:f)];o+=l,e+=c?2:1+l}return e}function yl(r,e,t,n,s){let i=0,o=0;for(;i<n;){if(e+4>r.length)throw we(`, line ${s}: the file ends there`);if(r[e]===1&&r[e+1]===1&&r[e+2]===1){if(i===0)throw we(`, line ${s}: a run repeats a pixel, but there is none before it`);let c=o>16?1/0:r[e+3]*2**o;if(i+c>n)throw we(`, line ${s}: a run goes past the line's end`);for(let l=0;l<c;l++)t.copyWithin(4*(i+l),4*(i-1),4*i);i+=c,o+=8}else t.set(r.subarray(e,e+4),4*i),i+=1,o=0;e+=4}return e}var wl=[118,47,49,1],xl=[35,63];function ts(r,e){let t=new Uint8Array(r),n=i=>i.every((o,c)=>t[c]===o),s=n(wl)?Li:n(xl)?Fi:null;if(s===null)throw new G(`${e}: is ${Nt(t)??"neither an EXR nor a Radiance HDR image"}`);try{return bl(s(t))}catch(i){let o=i instanceof G?i.message:`cannot read the image: ${i.message??i}`;throw new G(`${e}: ${o}`)}}function bl(r){let{rgb:e}=r,t=0;for(let n=0;n<e.length;n+=3){let s=!0;for(let i=n;i<n+3;i++)s&&=Number.isFinite(e[i])&&e[i]<=Oi,e[i]>0||(e[i]=0);s||t++}if(t)throw new G(`has ${t} texels that are not finite numbers of at most 1e+18`);return r}function Ci(r){return r.replaceAll("#","%23").replace(/%(?![0-9a-f]{2})/gi,"%25")}var zi={blocks:[{name:"features",width:null,kinds:["surface","fiber"],light:!1},{name:"position",width:3,kinds:["surface","fiber"],light:!1},{name:"normal",width:3,kinds:["surface"],light:!1},{name:"tangent",width:3,kinds:["fiber"],light:!1},{name:"h",width:1,kinds:["fiber"],light:!1},{name:"wo",width:3,kinds:["surface","fiber"],light:!1},{name:"wi",width:3,kinds:["surface","fiber"],light:!0},{name:"half_vector",width:5,kinds:["surface"],light:!0},{name:"highlight",width:1,kinds:["surface"],light:!0},{name:"learned_normal",width:2,kinds:["surface"],light:!0},{name:"fiber_angles",width:6,kinds:["fiber"],light:!0},{name:"fiber_lobes",width:3,kinds:["fiber"],light:!0}]};var er=zi.blocks,pt=r=>er.find(e=>e.name===r),tr=(r,e)=>pt(r).width??e;var et=22,dt=46,hn=30,Ui=64,Di=256,El=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,Ct="manifest.json",Hi=2**20,dn=r=>new DataView(r.buffer,r.byteOffset,r.byteLength);async function $i(r){let{size:e}=r;e===0&&y("FILE_EMPTY",r.name,"the file has no bytes"),e>2**32-2&&y("FILE_TOO_LARGE",r.name,`${e} bytes`);let{count:t,start:n}=await Rl(r),s=await r.read(n,e-et),i=Sl(s,t,n,r.name);return Tl(i,n,r.name),new Map(i.map(o=>[o.name,o]))}async function Rl(r){let{size:e,name:t}=r,n=await r.read(0,Math.min(512,e)),s=Nt(n);s&&y("ZIP_NOT_ZIP",t,`expected a package, found ${s}`);let o=e>=4&&dn(n).getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";e<et&&y(o,t,"shorter than the end record of a ZIP archive");let c=dn(await r.read(e-et,e)),l=e===et&&c.getUint32(0,!0)===101010256;c.getUint32(0,!0)!==101010256&&await kl(r,o);let f=w=>c.getUint16(w,!0);[4,6,8,10].some(w=>f(w)===65535)&&y("ZIP_ZIP64",t,"a ZIP64 archive"),(f(4)||f(6))&&y("ZIP_ZIP64",t,"an archive of several disks");let p=f(10),d=c.getUint32(12,!0),_=c.getUint32(16,!0);return p>Di&&y("ZIP_TOO_MANY",t,`${p} entries; at most ${Di}`),(f(8)!==p||f(20)!==0||_+d!==e-et)&&y("ZIP_DIRECTORY",t,"the end record does not fit the central directory"),(l||p===0)&&y("ZIP_ORDER",t,`${Ct} is not the first entry`),{count:p,start:_}}async function kl(r,e){let t=await r.read(Math.max(0,r.size-et-65535),r.size),n=dn(t);for(let s=t.length-et;s>=0;s--)n.getUint32(s,!0)===101010256&&s+et+n.getUint16(s+20,!0)===t.length&&y("ZIP_DIRECTORY",r.name,"the archive has a comment");y(e,r.name,"the file does not end with the end record of a ZIP archive")}function Sl(r,e,t,n){let s=dn(r),i=[],o=new Set,c=0;for(let l=0;l<e;l++){(c+dt>r.length||s.getUint32(c,!0)!==33639248)&&y("ZIP_DIRECTORY",n,`the central directory has no header ${l}`);let f=s.getUint16(c+28,!0);(c+dt+f>r.length||s.getUint32(c+30,!0))&&y("ZIP_DIRECTORY",n,`header ${l} of the central directory is malformed`);let p=r.subarray(c+dt,c+dt+f),d=String.fromCharCode(...p);Il(s,c,d,n),(!El.test(d)||d.includes(`
`)||f>200)&&y("ZIP_NAME",n,`an entry is called ${JSON.stringify(d.slice(0,80))}`);let _=d.toLowerCase();o.has(_)&&y("ZIP_DUPLICATE",d,"the name is there twice"),o.add(_),i.push({name:d,size:s.getUint32(c+24,!0),crc:s.getUint32(c+16,!0),header:s.getUint32(c+42,!0),central:r.subarray(c,c+dt+f)}),c+=dt+f}c!==r.length&&y("ZIP_DIRECTORY",n,"bytes behind the last central header");for(let{name:l,header:f,size:p}of i)f+hn+l.length+p>t&&y("ZIP_TRUNCATED",l,`${p} bytes reach past the entries`);return i}function Il(r,e,t,n){let s=l=>r.getUint16(e+l,!0),i=l=>r.getUint32(e+l,!0),o=JSON.stringify(t.slice(0,80));(i(42)===4294967295||i(20)===4294967295||i(24)===4294967295)&&y("ZIP_ZIP64",n,`${o} needs ZIP64`),s(34)&&y("ZIP_ZIP64",n,`${o} is on another disk`),s(8)&1&&y("ZIP_ENCRYPTED",n,`${o} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([l,f])=>s(l)!==f)||i(38))&&y("ZIP_HEADER",n,`${o}: a version, flag, time or attribute is not the fixed one`),s(10)&&y("ZIP_COMPRESSED",n,`${o} is compressed`),i(20)!==i(24)&&y("ZIP_SIZE",n,`${o} has two sizes`)}function Tl(r,e,t){let n=[...r].sort((o,c)=>o.header-c.header),s=0;n.forEach((o,c)=>{o.end=c+1<n.length?n[c+1].header:e,o.extra=o.end-o.header-hn-o.name.length-o.size,o.extra<0&&y("ZIP_OVERLAP",o.name,"shares bytes with the next entry"),o.header!==s&&y("ZIP_GAP",t,`bytes ${s} to ${o.header} are no entry's`),s=o.end});let i=n[0];i.name!==Ct&&y("ZIP_ORDER",t,`${Ct} is not the first entry`),i.size>Hi&&y("MANIFEST_TOO_LARGE",Ct,`${i.size} bytes; at most ${Hi}`)}function Gi(r,e){let t=dn(e),{name:n}=r,s=r.name.length;e.length<r.end-r.header&&y("ZIP_TRUNCATED",n,"the file ends within it"),t.getUint32(0,!0)===67324752&&t.getUint16(26,!0)===s&&Bi(e.subarray(4,26),r.central.subarray(6,28))&&Bi(e.subarray(hn,hn+s),r.central.subarray(dt))||y("ZIP_LOCAL_HEADER",n,"local and central header differ");let o=t.getUint16(28,!0),c=hn+s;Nl(e.subarray(c,c+o),o,n),(r.header+c+o)%Ui&&y("ZIP_ALIGNMENT",n,`data at byte ${r.header+c+o}, no multiple of ${Ui}`),o!==r.extra&&y(o>r.extra?"ZIP_OVERLAP":"ZIP_GAP",n,"its data does not end where the next entry starts");let l=e.subarray(c+o,c+o+r.size);return Ol(l)!==r.crc&&y("ZIP_CRC",n,"the bytes do not have the CRC-32 of the header"),l}function Nl(r,e,t){if(e===0)return;e>=4&&r.length===e&&r[0]===82&&r[1]===78&&r[2]+256*r[3]===e-4&&r.subarray(4).every(s=>s===0)||y("ZIP_EXTRA",t,"the extra field is not zero padding")}var Bi=(r,e)=>r.length===e.length&&r.every((t,n)=>t===e[n]),pn=Array.from({length:4},()=>new Uint32Array(256));for(let r=0;r<256;r++){let e=r;for(let t=0;t<8;t++)e=e&1?e>>>1^3988292384:e>>>1;pn[0][r]=e>>>0}for(let r=1;r<4;r++)for(let e=0;e<256;e++){let t=pn[r-1][e];pn[r][e]=t>>>8^pn[0][t&255]}function Ol(r){let[e,t,n,s]=pn,i=4294967295,o=0;for(;o+4<=r.length;o+=4)i^=r[o]|r[o+1]<<8|r[o+2]<<16|r[o+3]<<24,i=s[i&255]^n[i>>>8&255]^t[i>>>16&255]^e[i>>>24];for(;o<r.length;o++)i=e[(i^r[o])&255]^i>>>8;return(i^4294967295)>>>0}var Ml=64,Ll=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,Pl=/[ \t\n\r]*/y,Fl=/[^"\\\u0000-\u001f]*/y,qi={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function zt(r,e,t){let n;try{n=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(r)}catch{y(t,e,"no UTF-8")}let s=new ns(n,e,t);s.space(),n[s.at]!=="{"&&y(t,e,"not a JSON object");let i=s.value(1);return s.space(),s.at!==n.length&&s.bad(),i}var ns=class{constructor(e,t,n){Object.assign(this,{text:e,where:t,code:n,at:0})}bad(e="malformed JSON"){y(this.code,this.where,`${e} at character ${this.at}`)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t&&(this.at=e.lastIndex),t}space(){this.match(Pl)}take(e){return this.text.startsWith(e,this.at)?(this.at+=e.length,!0):!1}value(e){let t=this.text[this.at];if((t==="{"||t==="[")&&e>Ml&&this.bad("nested too deep"),t==="{")return this.object(e);if(t==="[")return this.array(e);if(t==='"')return this.string();for(let[i,o]of[["true",!0],["false",!1],["null",null]])if(this.take(i))return o;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let n=this.match(Ll);n||this.bad();let s=Number(n[0]);return Number.isFinite(s)||this.notFinite(),s===0?0:s}notFinite(){y("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(e,t){if(this.at+=1,this.space(),!this.take(e)){do this.space(),t(),this.space();while(this.take(","));this.take(e)||this.bad()}}array(e){let t=[];return this.list("]",()=>t.push(this.value(e+1))),t}object(e){let t=new Map;this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let s=this.string();t.has(s)&&y("JSON_DUPLICATE_KEY",this.where,`the key "${s}" twice`),this.space(),this.take(":")||this.bad(),this.space(),t.set(s,this.value(e+1))});let n=Object.create(null);for(let[s,i]of t)n[s]=i;return n}string(){let e="";for(this.at+=1;e+=this.match(Fl)[0],!this.take('"');){this.take("\\")||this.bad();let t=this.text[this.at++];if(t==="u"){let n=this.match(/[0-9a-fA-F]{4}/y);n||this.bad(),e+=String.fromCharCode(parseInt(n[0],16))}else t in qi?e+=qi[t]:this.bad()}return e.isWellFormed()||this.bad("half of a surrogate pair"),e}};var ji={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},Cl=65536;function Ut(r,e,t,n){let s=e.byteOffset+t;return s%r.BYTES_PER_ELEMENT===0?new r(e.buffer,s,n):new r(e.slice(t,t+n*r.BYTES_PER_ELEMENT).buffer)}function tt(r,e,t){r.length<8&&y(t,e,"shorter than a header");let n=new DataView(r.buffer,r.byteOffset).getBigUint64(0,!0);(n>Cl||Number(n)>r.length-8)&&y(t,e,`a header of ${n} bytes`);let s=8+Number(n);r[8]!==123&&y(t,e,"the header does not start with {");let{__metadata__:i,...o}=zt(r.subarray(8,s),e,t);return{tensors:o,metadata:i,data:s}}var Yi=r=>r!==null&&typeof r=="object"&&!Array.isArray(r),Zi=r=>Number.isSafeInteger(r)&&r>=0;function nt(r){return Yi(r)&&typeof r.dtype=="string"&&Array.isArray(r.shape)&&r.shape.every(Zi)&&Array.isArray(r.data_offsets)&&r.data_offsets.length===2&&r.data_offsets.every(Zi)}var rt=r=>r===void 0||Yi(r);function st(r,{tensors:e,data:t},n,s,i){let o=0,c=n.map(l=>{let{dtype:f,shape:p,data_offsets:[d,_]}=e[l],w=p.reduce((A,R)=>A*R,1);return(d!==o||_-d!==w*ji[f].BYTES_PER_ELEMENT||t+_>r.length)&&y(i,s,`the bytes of ${l} are not where they must be`),o=_,Ut(ji[f],r,t+d,w)});return t+o!==r.length&&y(i,s,"bytes behind the last tensor"),c}var Wi=2**26,zl=2**25,Ul=2**31,Dl={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},Hl={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function Vi(r,e){let t=tt(r,e,"GEOMETRY_CONTAINER"),{tensors:n}=t,s="steps"in n||"scales"in n,i=s?Hl:Dl,o=Object.keys(i);Bl(t,i,o,e);let c=Object.fromEntries(o.map(A=>[A,n[A].shape])),l=st(r,t,o,e,"GEOMETRY_RANGE"),f=Object.fromEntries(o.map((A,R)=>[A,l[R]])),p=c.offsets[0]-1,d=c.radii[0];(!(s?c.origins[0]===p&&c.steps[0]===d-p&&c.scales[0]===2:c.points[0]===d)||p<1)&&y("GEOMETRY_ARRAY",e,"tensors whose shapes do not fit each other"),$l(f.offsets,d,e);let w=s?Gl(f,e):f;return ql(w,e),w}function Bl(r,e,t,n){let{tensors:s}=r,i="GEOMETRY_PROFILE",o=Object.keys(s);(o.length!==t.length||t.some(l=>!o.includes(l)))&&y(i,n,`found ${o.join(", ")||"no tensors"}, expected ${t.join(", ")}`),rt(r.metadata)||y(i,n,"__metadata__ is no object");for(let[l,[f,p]]of Object.entries(e)){let d=s[l];nt(d)&&f.includes(d.dtype)&&d.shape.length===p&&(p===1||d.shape[1]===3)||y(i,n,`${l} is not ${f.join(" or ")} of ${p} dimensions`)}((s.points??s.radii).shape[0]>Wi||s.radii.shape[0]>Wi||s.offsets.shape[0]-1>zl)&&y(i,n,"more points or strands than allowed"),r.data%64&&y(i,n,"data does not start at a multiple of 64")}function $l(r,e,t){let n=r[0]===0&&r.at(-1)===e;for(let s=1;s<r.length&&n;s++)n=r[s]>=r[s-1]+2;n||y("GEOMETRY_STRANDS",t,"the offsets do not part the points into strands")}function Gl({scales:r,origins:e,offsets:t,steps:n,radii:s},i){let[o,c]=r;o>0&&Number.isFinite(o)||y("GEOMETRY_STEPS",i,"steps without length"),e.some(p=>!Number.isFinite(p))&&y("GEOMETRY_NOT_FINITE",i,"an origin is not finite"),(!(c>0&&Number.isFinite(c))||s.some(p=>p===0))&&y("GEOMETRY_RADIUS",i,"a radius that is not above 0");let l=new Float32Array(3*s.length),f=0;for(let p=0;p+1<t.length;p++){for(let d=0;d<3;d++){let _=e[3*p+d],w=0;l[3*t[p]+d]=_;for(let A=t[p]+1,R=f;A<t[p+1];A++,R++)w+=n[3*R+d],Math.abs(w)>Ul&&y("GEOMETRY_STEPS",i,`strand ${p} goes too far`),l[3*A+d]=_+o*w}f+=t[p+1]-t[p]-1}return{points:l,radii:Float32Array.from(s,p=>p*c),offsets:t}}function ql({points:r,radii:e,offsets:t},n){(r.some(s=>!Number.isFinite(s))||e.some(s=>!Number.isFinite(s)))&&y("GEOMETRY_NOT_FINITE",n,"a point or a radius is not finite");for(let s=0;s+1<t.length;s++)for(let i=t[s]+1;i<t[s+1];i++)r[3*i]===r[3*i-3]&&r[3*i+1]===r[3*i-2]&&r[3*i+2]===r[3*i-1]&&y("GEOMETRY_SEGMENT",n,`two equal points in strand ${s}`);e.some(s=>!(s>0))&&y("GEOMETRY_RADIUS",n,"a radius that is not above 0")}var rs=[0,1,-1,1e4,-1e4,34028234663852886e22,-34e37],jl=5,Zl=34028234663852886e22;function Ki(r,e){let t=1,n=()=>(t=Math.imul(t,1664525)+1013904223|0)/2**31;for(let s=0;s<rs.length+jl;s++){let i=Float32Array.from({length:r.columns},()=>rs[s]??n()),o=Yl(r,i).find(c=>!(c>=0&&c<=Zl));o!==void 0&&y("DECODER_RESULT",e,`a query of ${rs[s]??"random"} numbers gives ${o}, expected finite results, not negative`)}}function Yl({low:r,high:e,gain:t,offset:n,layers:s,top:i,unit:o,matrix:c,outputs:l},f){let p=f.map(w=>Math.min(Math.max(w,r),e)),d=t?p.map((w,A)=>w*t[A]+n[A]):p;for(let w of s)d=Wl(w,d);let _=d.map(w=>(Math.exp(Math.min(Math.max(w,0),i))-1)*o);return c?Xi(_,c,l):_}function Wl({weight:r,bias:e,columns:t,step:n,scales:s,relu:i},o){let c=s?o.map(l=>l/n>0?Vl(Math.min(l/n,255)):0):o;return Xi(c,r,t).map((l,f)=>{let p=s?(l+e[f])*n*s[f]:l+e[f];return i?Math.max(p,0):p})}var Vl=r=>r+1.5*2**52-1.5*2**52;function Xi(r,e,t){let n=new Float64Array(t);return r.forEach((s,i)=>{if(s!==0)for(let o=0,c=i*t;o<t;o++,c++)n[o]+=s*e[c]}),Float32Array.from(n)}var Se=1,is=2,os=3,as=6,Kl={[Se]:Float32Array,[is]:Uint8Array,[os]:Int8Array,[as]:Int32Array},Ji=[3,4,5,6,7,10,11,13],Qi=2**18;function to(r,{columns:e,outputs:t,output:n},s){let i=new ss(s),o=i.message(r,{1:"number",7:"bytes",8:"many",20:"many",25:"many"}),c=o[8].map(f=>i.message(f,{1:"text",2:"number"})),l=i.message(o[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});return o[1]>=7&&o[1]<=10||s(`IR version ${o[1]}, expected 7 to 10`),(c.length!==1||!no(c[0][1])||!(c[0][2]>=13&&c[0][2]<=21))&&s("operators that are not those of ONNX, version 13 to 21"),(o[20].length||o[25].length||l[15].length)&&s("functions, training or sparse tensors"),eo(i,l[11],"queries",e),eo(i,l[12],n,t),{nodes:l[1].map(f=>Xl(i,f)),constants:l[5].map(f=>Jl(i,f))}}var no=r=>r===""||r==="ai.onnx";function eo(r,e,t,n){let[s]=e.map(l=>r.message(l,{1:"text",2:"bytes"})),i=s&&r.message(r.message(s[2],{1:"bytes"})[1],{1:"number",2:"bytes"}),o=i&&r.message(i[2],{1:"many"})[1].map(l=>r.message(l,{1:"number?",2:"text"})[1]);e.length===1&&s[1]===t&&i[1]===Se&&o.length===2&&o[0]===void 0&&o[1]===n||r.outside(`not one ${t}, float32 [N, ${n}]`)}function Xl(r,e){let t=r.message(e,{1:"many",2:"many",4:"text",5:"many",7:"text"});(!no(t[7])||t[2].length!==1)&&r.outside(`${t[4]} of another domain, or of several results`);let n=t[5].map(s=>r.message(s,{1:"text",3:"number?"}));return(n.some(({1:s,3:i})=>s!=="axis"||i===void 0)||n.length>1)&&r.outside(`${t[4]} with another attribute than axis`),{operator:t[4],inputs:t[1].map(r.text),output:r.text(t[2][0]),axis:n[0]?.[3]??null}}function Jl(r,e){let t=Object.fromEntries(Ji.map(p=>[p,"many"])),n=r.message(e,{1:"numbers",2:"number",8:"text",9:"bytes",14:"number",...t});(n[14]||Ji.some(p=>n[p].length))&&r.outside("a constant not in raw_data");let{1:s,2:i,9:o}=n,c=Kl[i],l=s.reduce((p,d)=>p*d,1),f=c&&s.length<=2&&o.length===l*c.BYTES_PER_ELEMENT;return{name:n[8],type:i,dims:s,values:f?Ut(c,o,0,l):null}}var ss=class{constructor(e){this.outside=e,this.fields=0,this.text=t=>{try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{return e("a name that is no UTF-8")}}}message(e,t){let n=Object.fromEntries(Object.keys(t).map(s=>[s,[]]));for(let s=0;s<e.length;){++this.fields>Qi&&this.outside("too many fields");let i,o;[i,s]=this.varint(e,s),[o,s]=this.value(e,s,i%8),n[Math.floor(i/8)]?.push(o)}return Object.fromEntries(Object.entries(t).map(([s,i])=>[s,this.taken(n[s],i)]))}taken(e,t){if(t==="numbers")return e.flatMap(s=>typeof s=="number"?s:this.packed(s));let n=t.startsWith("number");return e.some(s=>typeof s=="number"!==n)&&this.outside("a field of another type"),t==="many"?e:(e.length>1&&this.outside("a field twice"),n?e[0]??(t==="number"?0:void 0):t==="text"?this.text(e[0]??new Uint8Array):e[0]??new Uint8Array)}packed(e){let t=[];for(let n=0,s;n<e.length;)++this.fields>Qi&&this.outside("too many numbers"),[s,n]=this.varint(e,n),t.push(s);return t}value(e,t,n){if(n===0)return this.varint(e,t);let s={1:8,5:4}[n];return n===2&&([s,t]=this.varint(e,t)),(s===void 0||t+s>e.length)&&this.outside("a field that is cut short"),[e.subarray(t,t+s),t+s]}varint(e,t){for(let n=0,s=1,i=0;i<10&&t<e.length;i++,s*=128){let o=e[t++];if(n+=(o&127)*s,o<128)return[n,t]}return this.outside("a number that is cut short")}};var ro=64*2**20,so=4096,io=8192,oo=2**16,ao=2**24,it=[Se,[]],co=[is,[]];function lo(r,{columns:e,outputs:t,output:n,precision:s},i){r.length>ro&&y("DECODER_TOO_LARGE",i,`${r.length} bytes; at most ${ro}`);let o=f=>y("DECODER_PROFILE",i,`not a decoder as the format has it: ${f}`),c=to(r,{columns:e,outputs:t,output:n},o),l=new cs(c,{columns:e,outputs:t,output:n,int8:s==="int8"},i,o).decoder();return Ki(l,i),l}var cs=class{constructor({nodes:e,constants:t},n,s,i){Object.assign(this,n,{where:s,outside:i,width:n.columns,value:"queries",values:n.outputs,work:0}),e.length>so&&i(`${e.length} nodes; at most ${so}`);let o=["queries",...t.map(({name:c})=>c),...e.map(({output:c})=>c)];(new Set(o).size!==o.length||o.includes(""))&&i("a value made twice, or without a name"),this.constants=new Map(t.map(c=>[c.name,c])),this.unread=new Set(this.constants.keys()),this.dequantizers=new Map,this.nodes=e.values(),this.advance()}advance(){for(;;){if(this.node=this.nodes.next().value,this.node?.operator!=="DequantizeLinear"||!this.constants.has(this.node.inputs[0]))return;this.dequantizers.set(this.node.output,this.node)}}get operator(){return this.node?.operator??"nothing"}next(e,t){let{node:n}=this;return this.operator!==e&&this.outside(`${this.operator} where ${e} must be`),(n.inputs[0]!==this.value||n.inputs.length!==t+1||n.axis!==null)&&this.outside(`${e} of ${n.inputs.join(", ")}, not of ${this.value} and ${t} constants`),this.value=n.output,this.advance(),n.inputs.slice(1)}read(e,t){return e.length!==t.length&&this.outside(`${e.length} constants where ${t.length} must be`),t.map(([n,s],i)=>{let{values:o,...c}=this.constants.get(e[i])??{};return(!o||c.type!==n||c.dims.join()!==s.join())&&this.outside(`${e[i]} is no constant of type ${n} and shape [${s}]`),n===Se&&!o.every(Number.isFinite)&&y("DECODER_RESULT",this.where,`${e[i]} has values that are NaN or infinite`),this.unread.delete(e[i]),o})}take(e,...t){return this.read(this.next(e,t.length),t)}multiply(e,{isLayer:t}){let n=this.constants.get(e)?.dims[1]??0,s=this.width;return n>=1&&n<=io||this.outside(`${e} has ${n} columns; from 1 to ${io}`),t&&(this.values+=n),this.work+=s*n,(this.values>oo||this.work>ao)&&y("DECODER_COST",this.where,`${this.values} values and ${this.work} multiply-adds of a query, or more; at most ${oo} and ${ao}`),this.width=n,{rows:s,columns:n}}decoder(){let e=[Se,[this.columns]],{int8:t,columns:n,outputs:s}=this,[[i],[o]]=this.take("Clip",it,it),[c]=t?this.take("Mul",e):[null],[l]=t?this.take("Add",e):[null],f=[];do f.push(t?this.int8Layer():this.layer());while(t?this.operator!=="Clip":f.at(-1).relu);let[[p],[d]]=this.take("Clip",it,it);this.take("Exp");let[[_]]=this.take("Sub",it);(p!==0||_!==1)&&this.outside(`Clip from ${p}, Sub of ${_}`);let w=this.operator==="MatMul"?this.mixing():{unit:this.take("Mul",it)[0][0],matrix:null};return(this.node||this.dequantizers.size||this.unread.size)&&this.outside("a node or a constant that the chain does not have"),(this.value!==this.output||this.width!==s)&&this.outside(`${this.width} columns of ${this.value} in the end`),{low:i,high:o,gain:c,offset:l,layers:f,top:d,...w,int8:t,columns:n,outputs:s}}mixing(){let e=this.next("MatMul",1),{rows:t,columns:n}=this.multiply(e[0],{isLayer:!1});return{unit:1,matrix:this.read(e,[[Se,[t,n]]])[0]}}layer(){let e=this.next("Gemm",2),{rows:t,columns:n}=this.multiply(e[0],{isLayer:!0}),[s,i]=this.read(e,[[Se,[t,n]],[Se,[n]]]),o=this.operator==="Relu";return o&&this.take("Relu"),{weight:s,bias:i,rows:t,columns:n,relu:o}}int8Layer(){let[[e],[t]]=this.take("QuantizeLinear",it,co),[[n],[s]]=this.take("DequantizeLinear",it,co);(t||s||e!==n)&&this.outside("two scales, or a zero point");let i=new Map(this.dequantizers),[o,c]=this.next("Gemm",2).map((A,R)=>this.dequantized(i,A,1-R)),{rows:l,columns:f}=this.multiply(o[0],{isLayer:!0}),[p,d]=this.read(o,[[os,[l,f]],[Se,[f]]]),[_,w]=this.read(c,[[as,[f]],[Se,[f]]]);return w.some((A,R)=>A!==Math.fround(e*d[R]))&&this.outside("a bias with a scale of its own"),{weight:p,bias:_,rows:l,columns:f,step:e,scales:d,relu:!1}}dequantized(e,t,n){let s=e.get(t);return(s?.axis!==n||!this.dequantizers.delete(t))&&this.outside(`${t} is no DequantizeLinear of constants along axis ${n}`),s.inputs}};async function uo(r,{elementSize:e,distance:t,size:n},s){let i=await Ql(r,n,s),o=Math.floor(n/e),c=new Uint8Array(n);for(let l=0;l<e;l++){let f=l*o;for(let p=0;p<o;p++)c[p*e+l]=i[f+p]}if(c.set(i.subarray(o*e),o*e),t){let l={1:Uint8Array,2:Uint16Array,4:Uint32Array}[e],f=new l(c.buffer,0,o);for(let p=t;p<o;p++)f[p]+=f[p-t]}return c}async function Ql(r,e,t){let n=new Uint8Array(e),s=0;try{let i=new Blob([r]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:o,value:c}=await i.read();if(o)break;if(s+c.length>e)throw i.cancel().catch(()=>{}),new RangeError(`more than ${e} bytes`);n.set(c,s),s+=c.length}}catch(i){y("DEFLATE_STREAM",t,`no whole zlib stream of ${e} bytes (${i.message})`)}return s!==e&&y("DEFLATE_STREAM",t,`inflates to ${s} bytes, expected ${e}`),n}var Dt={$schema:"https://json-schema.org/draft/2020-12/schema",title:"Manifest",$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"Cost of a query.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder per query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds per query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Trained directions, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Origin of the asset.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"Emission of a part: a separate decoder on features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierPart:{additionalProperties:!1,description:"Planes and decoders of one part: of transport, and optionally of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}},additionalProperties:!1,description:"manifest.json. `write_package` computes `entries`; leave them out.",properties:{format:{const:"rna",type:"string"},version:{const:"2.0",description:"Version of the format.",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"}},required:["format","version","units","entries","generator","name","parts","domain","tiers","provenance","license"],type:"object"};var Ht=16,tu=32,{emission:vp,...fo}=Dt.$defs.TierPart.properties,ho={$defs:Dt.$defs,type:"object",required:["parts"],additionalProperties:!1,properties:{parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"object",additionalProperties:!1,required:[...Dt.$defs.TierPart.required,"lobes"],properties:{...fo,lobes:{type:"integer",minimum:2,maximum:tu},visibility:fo.planes}}]}},validation:{type:"array",maxItems:64}}};function po(r){let e=r.extensions?.RNA_environment?.parts;return e?.every(t=>t)?e:null}function mo({parts:r},e,t){r.some(n=>n)||y("FIELD_VALUE",t,"lobes of no part"),r.forEach((n,s)=>{if(!n)return;let i=`${t}/parts/${s}`;n.lobes%2&&y("FIELD_VALUE",`${i}/lobes`,`found ${n.lobes}, expected an even number`);for(let o of n.inputs)pt(o).kinds.includes(e.parts[s].kind)||y("INPUT_KIND",`${i}/inputs`,`${o} is not for this part`);for(let o of nr([n]))Object.hasOwn(e.entries,o)||y("REFERENCE_MISSING",i,`no entry ${o}`)})}var nr=r=>r.flatMap(({planes:e,decoder:t,visibility:n})=>[e,t,...n?[n]:[]]);function go(r,e,t){let n="ENVIRONMENT_VISIBILITY",s=tt(r,t,n),i=s.tensors.harmonics;rt(s.metadata)||y(n,t,"__metadata__ is no object"),(Object.keys(s.tensors).join()!=="harmonics"||!nt(i))&&y(n,t,"not one tensor harmonics");let o=[e,Ht];return(i.dtype!=="I8"||i.shape.join()!==o.join())&&y(n,t,`found ${i.dtype} [${i.shape}], expected I8 [${o}]`),s.data%64&&y(n,t,"data does not start at a multiple of 64"),st(r,s,["harmonics"],t,n)[0]}var ls={object:r=>r!==null&&typeof r=="object"&&!Array.isArray(r),array:Array.isArray,string:r=>typeof r=="string",number:r=>typeof r=="number",integer:r=>Number.isSafeInteger(r),boolean:r=>typeof r=="boolean",null:r=>r===null};function Bt(r,e,t=""){new fs(r).check(r,e,t)}var fs=class{constructor(e){this.root=e}fits(e,t){try{return this.check(e,t,""),!0}catch{return!1}}check(e,t,n){e.$ref&&this.check(this.root.$defs[e.$ref.split("/").pop()],t,n);let s=i=>y("FIELD_VALUE",n,`found ${us(t)}, expected ${i}`);e.type&&!ls[e.type](t)&&s(e.type),"const"in e&&t!==e.const&&s(us(e.const)),e.enum&&!e.enum.includes(t)&&(e.enum.includes("features")&&y("INPUT_UNKNOWN",n,`no block ${us(t)}`),s(e.enum.join(", ")));for(let i of[e.anyOf,e.oneOf])i&&!i.some(o=>this.fits(o,t))&&this.check(i.find(o=>ls[o.type]?.(t))??i[0],t,n);e.not&&this.fits(e.not,t)&&s("another value"),typeof t=="number"&&this.checkNumber(e,t,s),typeof t=="string"&&this.checkString(e,t,s),Array.isArray(t)?this.checkArray(e,t,n,s):ls.object(t)&&this.checkObject(e,t,n)}checkNumber(e,t,n){t<e.minimum&&n(`at least ${e.minimum}`),t>e.maximum&&n(`at most ${e.maximum}`),t<=e.exclusiveMinimum&&n(`more than ${e.exclusiveMinimum}`),t>=e.exclusiveMaximum&&n(`less than ${e.exclusiveMaximum}`)}checkString(e,t,n){t.length<e.minLength&&n(`${e.minLength} characters or more`),t.length>e.maxLength&&n(`at most ${e.maxLength} characters`),e.pattern&&!new RegExp(e.pattern,"u").test(t)&&n(e.pattern)}checkArray(e,t,n,s){t.length<e.minItems&&s(`${e.minItems} items or more`),t.length>e.maxItems&&s(`at most ${e.maxItems} items`),t.forEach((i,o)=>{let c=e.prefixItems?.[o]??e.items;c&&this.check(c,i,`${n}/${o}`)}),e.uniqueItems&&new Set(t).size!==t.length&&y("INPUT_UNKNOWN",n,"a name twice")}checkObject(e,t,n){let s=Object.keys(t),i=e.properties??{};for(let o of s)e.additionalProperties===!1&&!Object.hasOwn(i,o)&&y("FIELD_UNKNOWN",`${n}/${o}`,"no such member"),e.propertyNames&&this.check({type:"string",...e.propertyNames},o,`${n}/${o}`);for(let o of e.required??[])Object.hasOwn(t,o)||y("FIELD_MISSING",`${n}/${o}`,"missing");for(let o of s){let c=Object.hasOwn(i,o)?i[o]:e.additionalProperties;c&&this.check(c,t[o],`${n}/${o}`)}}};function us(r){let e=JSON.stringify(r);return e.length>60?`${e.slice(0,57)}...`:e}var hs={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},mn=(r,e=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:r,maximum:e}),ps={type:"number",minimum:0,maximum:1},mt=r=>({type:"object",properties:r,required:Object.keys(r),additionalProperties:!1}),_o=2**32-2,nu=2**20,ru=64,vo={RNA_deflate:mt({entries:{type:"object",propertyNames:hs,additionalProperties:mt({elementSize:{enum:[1,2,4]},distance:mn(0),size:mn(0,_o),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:mt({image:hs,width:mn(1),height:mn(1)}),RNA_standin:mt({parts:{type:"array",minItems:1,maxItems:16,items:mt({baseColor:{type:"array",items:ps,minItems:3,maxItems:3},roughness:ps,metallic:ps})}}),RNA_proxy:mt({parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"array",minItems:1,maxItems:8,items:mt({geometry:hs,height:mn(1)})}]}}}),RNA_environment:ho},rr=Object.keys(vo);function yo(r){let e=r.extensions??{};for(let t of rr){let n=`/extensions/${t}`;if(!Object.hasOwn(e,t)){r.extensionsUsed?.includes(t)&&y("FIELD_MISSING",n,"its data is missing");continue}Bt(vo[t],e[t],n),su[t](e[t],r,n)}}function ds(r,e,t){Object.hasOwn(r.entries,e)||y("REFERENCE_MISSING",t,`no entry ${e}`)}function ms(r,e,t){r.length!==e.parts.length&&y("PARTS_DIFFER",t,`found ${r.length} parts, expected ${e.parts.length}`)}var su={RNA_deflate({entries:r},e,t){e.extensionsRequired?.includes("RNA_deflate")||y("EXTENSION_UNDECLARED",t,"RNA_deflate is not in extensionsRequired");let n=Object.values(r).reduce((s,{size:i})=>s+i,0);n>_o&&y("FIELD_VALUE",t,`${n} decoded bytes`);for(let[s,{size:i}]of Object.entries(r)){ds(e,s,t);let o=nu+ru*e.entries[s].size;i>o&&y("DEFLATE_SIZE",`${t}/entries/${s}/size`,`${i} decoded bytes; at most ${o}`)}},RNA_poster({image:r},e,t){ds(e,r,t)},RNA_standin({parts:r},e,t){ms(r,e,t)},RNA_proxy({parts:r},e,t){ms(r,e,t),r.some(n=>n)||y("FIELD_VALUE",t,"a proxy of no part"),r.forEach((n,s)=>{let{transmittance:i,normalMaps:o}=e.parts[s];n&&(i||o)&&y("FIELD_VALUE",t,"a proxy of a part with textures"),(n??[]).forEach(({geometry:c,height:l},f)=>{ds(e,c,t),f&&l>=n[f-1].height&&y("FIELD_VALUE",t,"heights must descend")})})},RNA_environment(r,e,t){ms(r.parts,e,t),mo(r,e,t)}};var gs="2.0",iu=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;function wo(r){let e=zt(r,"manifest.json","MANIFEST_NOT_JSON");ou(e),Bt(Dt,e),au(e),cu(e),lu(e),uu(e),yo(e),fu(e),hu(e),du(e);let t=(e.extensionsUsed??[]).filter(n=>!rr.includes(n));return{...e,warnings:t.map(n=>`unknown extension ${n}`)}}function ou(r){"format"in r||y("FIELD_MISSING","/format","missing"),r.format!=="rna"&&y("FORMAT_UNKNOWN","/format","this is no RNA package");let{version:e}=r;if(typeof e=="string"&&iu.test(e)&&e!==gs){let t=parseInt(e,10)<parseInt(gs,10)?"VERSION_TOO_OLD":"VERSION_TOO_NEW";y(t,"/version",`the package is of version ${e}; this viewer reads ${gs}`)}for(let t of Array.isArray(r.parts)?r.parts:[])t?.kind!==void 0&&!["surface","fiber"].includes(t.kind)&&y("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(t.kind)}, expected surface or fiber`);for(let t of Array.isArray(r.extensionsRequired)?r.extensionsRequired:[])typeof t=="string"&&!rr.includes(t)&&y("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${t}`)}function au(r){r.parts.forEach(({bounds:{min:e,max:t}},n)=>{e.forEach((s,i)=>{Math.fround(t[i])-Math.fround(s)>=1e-18||y("BOUNDS_EMPTY",`/parts/${n}/bounds`,`no extent along axis ${i}`)})});for(let e of["wo","wi"]){let t=r.domain[e];for(let{axis:n}of Array.isArray(t)?t:[])Math.abs(Math.hypot(...n)-1)>.001&&y("FIELD_VALUE",`/domain/${e}`,"an axis is no unit vector")}}function cu(r){for(let[e,t]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let n=r[e].map(({name:s})=>s);new Set(n).size!==n.length&&y(t,`/${e}`,"a name is there twice")}r.tiers.forEach(({validation:e},t)=>{(e?.flipAtHeight??[]).forEach(({height:n},s,i)=>{s&&n>=i[s-1].height&&y("FIELD_VALUE",`/tiers/${t}/validation/flipAtHeight/${s}`,"heights must descend")})})}function lu(r){r.tiers.forEach((e,t)=>{e.parts.length!==r.parts.length&&y("PARTS_DIFFER",`/tiers/${t}/parts`,`found ${e.parts.length}, expected ${r.parts.length}`),e.parts.forEach((n,s)=>{!n.emission!=!r.tiers[0].parts[s].emission&&y("PARTS_DIFFER",`/tiers/${t}/parts/${s}`,"emission in some tiers alone")})})}function uu(r){let e=r.extensionsUsed??[];for(let t of[...Object.keys(r.extensions??{}),...r.extensionsRequired??[]])e.includes(t)||y("EXTENSION_UNDECLARED","/extensionsUsed",`${t} is not there`)}function fu(r){r.tiers.forEach((e,t)=>e.parts.forEach((n,s)=>{let{kind:i}=r.parts[s],o=(c,l)=>{for(let f of c)l(pt(f))||y("INPUT_KIND",`/tiers/${t}/parts/${s}/inputs`,`${f} is not for this part`)};o(n.inputs,({kinds:c})=>c.includes(i)),o(n.emission?.inputs??[],({kinds:c,light:l})=>c.includes(i)&&!l)}))}function hu(r){r.parts.forEach((e,t)=>{for(let[n,s]of[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"]]){let i=`/parts/${t}/${n}`;e[n]&&e.kind!=="surface"&&y("FIELD_VALUE",i,`of a ${e.kind}`);let o=0;(e[n]??[]).forEach(({triangles:[c,l]},f)=>{c<o&&y(s,`${i}/${f}`,"ranges must ascend and not overlap"),o=c+l})}})}function*pu(r){for(let[e,t]of r.parts.entries()){yield[`/parts/${e}/geometry`,t.geometry];for(let n of["transmittance","normalMaps"])for(let[s,i]of(t[n]??[]).entries())yield[`/parts/${e}/${n}/${s}`,i.texture]}for(let[e,t]of r.tiers.entries())for(let[n,s]of t.parts.entries()){let i=`/tiers/${e}/parts/${n}`;yield[`${i}/planes`,s.planes],yield[`${i}/decoder`,s.decoder],s.emission&&(yield[`${i}/emission/decoder`,s.emission.decoder])}}function du(r){let e=new Set;for(let[n,s]of pu(r))Object.hasOwn(r.entries,s)||y("REFERENCE_MISSING",n,`no entry ${s}`),e.add(s);let t=(r.extensionsUsed??[]).map(n=>`extensions/${n}/`);for(let n of Object.keys(r.entries))!e.has(n)&&!t.some(s=>n.startsWith(s))&&y("ENTRY_UNREFERENCED","/entries",`nothing refers to ${n}`)}function xo(r,e){for(let t of e.keys())t!=="manifest.json"&&!Object.hasOwn(r.entries,t)&&y("ENTRY_UNDECLARED","/entries",`the archive holds ${t}`);for(let[t,{size:n}]of Object.entries(r.entries)){let s=e.get(t);(!s||t==="manifest.json")&&y("ENTRY_MISSING","/entries",`the archive lacks ${t}`),s.size!==n&&y("ENTRY_SIZE",`/entries/${t}`,`found ${s.size}, expected ${n}`)}}var ot={type:"string"},bo={type:"array",items:{type:"number"}},Le=r=>({type:"integer",minimum:r,maximum:2**32-1}),at=r=>({type:"array",minItems:1,maxItems:1,items:r}),Pe=(r,e={})=>({type:"object",properties:{...r,...e},required:Object.keys(r),additionalProperties:!1}),Ao={type:"array",minItems:3,maxItems:3,items:{type:"number"}},Eo={const:"KHR_mesh_quantization"};function Ro(r){let e=r?[5122,5123,5125,5126]:[5125,5126],t=Pe({bufferView:Le(0),componentType:{enum:e},count:Le(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:Le(0),normalized:r?{type:"boolean"}:{const:!1},min:bo,max:bo,name:ot}),n=Pe({buffer:{const:0},byteLength:Le(1)},{byteOffset:Le(0),target:{enum:[34962,34963]},name:ot,...r&&{byteStride:{enum:[4,8]}}}),s=Pe({POSITION:Le(0),NORMAL:Le(0)},{TEXCOORD_0:Le(0)}),i=Pe({attributes:s,indices:Le(0)},{mode:{const:4}});return Pe({asset:Pe({version:{const:"2.0"}},{generator:ot,copyright:ot}),scenes:at(Pe({nodes:at({const:0})},{name:ot})),nodes:at(Pe({mesh:{const:0},...r&&{translation:Ao,scale:Ao}},{name:ot})),meshes:at(Pe({primitives:at(i)},{name:ot})),buffers:at(Pe({byteLength:Le(1)},{name:ot})),accessors:{type:"array",minItems:3,maxItems:4,items:t},bufferViews:{type:"array",minItems:1,maxItems:4,items:n},...r&&{extensionsUsed:at(Eo),extensionsRequired:at(Eo)}},{scene:{const:0},extras:{}})}var mu=Ro(!1),gu=Ro(!0);function ko(r,e){let t="extensionsUsed"in r||"extensionsRequired"in r;try{Bt(t?gu:mu,r)}catch(n){y("GEOMETRY_PROFILE",e,`${n.where}: not as meshes of packages are`)}return t&&_u(r.nodes[0],e),vu(r,t,e),t}function _u({scale:[r,e,t]},n){r>0&&r===e&&r===t||y("GEOMETRY_PROFILE",n,`the scale ${[r,e,t]}`)}function vu(r,e,t){let{attributes:n,indices:s}=r.meshes[0].primitives[0],i=e?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[c,l]of[...Object.entries(n),["indices",s]]){let f=r.accessors[l],p=f&&r.bufferViews[f.bufferView];if(!p)continue;let[d,_]=i[c];d.includes(f.type)&&_.some(([A,R,L])=>f.componentType===A&&(f.normalized??!1)===R&&p.byteStride===L)||y("GEOMETRY_PROFILE",t,`the accessor of ${c}`)}r.accessors[s]?.componentType===5123&&r.accessors[n.POSITION]?.count>=65535&&y("GEOMETRY_PROFILE",t,"indices of 16 bits for too many vertices")}var yu={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},wu={SCALAR:1,VEC2:2,VEC3:3};function So(r,e){let{json:t,bin:n}=xu(r,e),s=ko(t,e),i=t.buffers[0].byteLength;(i>n.length||n.length-i>3)&&y("GEOMETRY_RANGE",e,`a buffer of ${i} bytes in a chunk of ${n.length}`);let o=t.meshes[0].primitives[0],c=p=>bu(t,n.subarray(0,i),p,e),l={positions:c(o.attributes.POSITION),normals:c(o.attributes.NORMAL),uvs:"TEXCOORD_0"in o.attributes?c(o.attributes.TEXCOORD_0):null,indices:c(o.indices)};Au(l,e),Eu(t.accessors[o.attributes.POSITION],l.positions,s,e);let f=s?Ru(l,t.nodes[0]):l;return f.indices=Uint32Array.from(l.indices),ku(f,e),f}function xu(r,e){let t="GEOMETRY_CONTAINER",n=new DataView(r.buffer,r.byteOffset,r.length);(r.length<20||n.getUint32(0,!0)!==1179937895||n.getUint32(4,!0)!==2)&&y(t,e,"no binary glTF 2.0"),n.getUint32(8,!0)!==r.length&&y(t,e,"the length in the header is not that of the entry");let s=[];for(let i=12;i<r.length;){i+8>r.length&&y(t,e,"a chunk is cut short");let o=n.getUint32(i,!0),c=n.getUint32(i+4,!0);(o%4||i+8+o>r.length)&&y(t,e,`a chunk of ${o} bytes`),s.push([c,r.subarray(i+8,i+8+o)]),i+=8+o}return s.map(([i])=>i).join()!==[1313821514,5130562].join()&&y(t,e,"not the chunks JSON and BIN"),s[0][1].length>65536&&y(t,e,"JSON of more than 64 KiB"),{json:zt(s[0][1],e,t),bin:s[1][1]}}function bu(r,e,t,n){let s=r.accessors[t];s||y("GEOMETRY_RANGE",n,`no accessor ${t}`);let i=r.bufferViews[s.bufferView];i||y("GEOMETRY_RANGE",n,`no buffer view ${s.bufferView}`);let o=yu[s.componentType],c=wu[s.type],l=o.BYTES_PER_ELEMENT*c,f=i.byteStride??l,p=(i.byteOffset??0)+(s.byteOffset??0),d=(s.byteOffset??0)+f*(s.count-1)+l;(d>i.byteLength||(i.byteOffset??0)+i.byteLength>e.length)&&y("GEOMETRY_RANGE",n,`accessor ${t} reaches past its bytes`),p%4&&y("GEOMETRY_PROFILE",n,`accessor ${t} is not aligned`);let _=f===l?Ut(o,e,p,c*s.count):new o(c*s.count);if(f!==l){let w=Ut(o,e,p,Math.floor(d-(s.byteOffset??0))/o.BYTES_PER_ELEMENT),A=f/o.BYTES_PER_ELEMENT;for(let R=0;R<s.count;R++)for(let L=0;L<c;L++)_[c*R+L]=w[A*R+L]}return Object.assign(_,{items:c})}function Au({positions:r,normals:e,uvs:t,indices:n},s){let i=r.length/3;(e.length!==r.length||t&&t.length!==2*i||!i)&&y("GEOMETRY_ARRAY",s,"attributes of different counts"),(n.length%3||!n.length)&&y("GEOMETRY_ARRAY",s,"part of a triangle")}function Eu(r,e,t,n){["min","max"].every(i=>{if(r[i]?.length!==3)return!1;for(let o=0;o<3;o++){let c=e[o];for(let f=o;f<e.length;f+=3)(i==="min"?e[f]<c:e[f]>c)&&(c=e[f]);if((t?r[i][o]:Math.fround(r[i][o]))!==c&&Number.isFinite(c))return!1}return!0})||y("GEOMETRY_BOUNDS",n,"min and max of POSITION are not those of its values")}function Ru({positions:r,normals:e,uvs:t},{translation:n,scale:s}){return{positions:Float32Array.from(r,(i,o)=>n[o%3]+s[0]*i),normals:Float32Array.from(e,i=>Math.max(i/32767,-1)),uvs:t&&(t instanceof Uint16Array?Float32Array.from(t,i=>i/65535):t)}}function ku({positions:r,normals:e,uvs:t,indices:n},s){for(let o of[r,e,t??[]])for(let c=0;c<o.length;c++)Number.isFinite(o[c])||y("GEOMETRY_NOT_FINITE",s,"an attribute is not finite");let i=r.length/3;for(let o=0;o<n.length;o++)n[o]>=i&&y("GEOMETRY_INDEX",s,`vertex ${n[o]} of ${i}`);for(let o=0;o<e.length;o+=3){let c=Math.hypot(e[o],e[o+1],e[o+2]);Math.abs(c-1)>.001&&y("GEOMETRY_NORMAL",s,`a normal of length ${c}`)}}var Su={float16:"F16",float32:"F32",int8:"I8"},_s=1e18;function vs(r,{planePrecision:e,resolution:t,channels:n},s){let i=tt(r,s,"PLANES_HEADER"),{tensors:o}=i,c=e==="int8",l=c?{scales:["F32",[3,n]],planes:["I8",[3,t,t,n]]}:{planes:[Su[e],[3,t,t,n]]},f=Object.keys(l),p=Object.keys(o);rt(i.metadata)||y("PLANES_TENSOR",s,"__metadata__ is no object"),(p.length!==f.length||f.some(A=>!p.includes(A)))&&y("PLANES_TENSOR",s,`found ${p.join(", ")||"no tensors"}, expected ${f.join(", ")}`);for(let A of f)nt(o[A])||y("PLANES_HEADER",s,`${A} is no tensor`);for(let A of f){let[R,L]=l[A],H=o[A];H.dtype!==R&&y("PLANES_DTYPE",s,`${A}: found ${H.dtype}, expected ${R}`),H.shape.join()!==L.join()&&y("PLANES_SHAPE",s,`${A}: found [${H.shape}], expected [${L}]`)}let d=st(r,i,f,s,"PLANES_HEADER");i.data%64&&y("PLANES_ALIGNMENT",s,"data does not start at a multiple of 64");let _=d.at(-1),w=c?d[0]:null;return Iu(e,_,w,s),{values:_,scales:w,resolution:t,channels:n,precision:e}}function Iu(r,e,t,n){let s=()=>y("PLANES_NOT_FINITE",n,`NaN, or a value beyond ${_s}`);if(r==="int8")t.some(i=>!(Math.abs(i)*128<=_s))&&s();else if(r==="float16")for(let i=0;i<e.length;i++)(e[i]&31744)===31744&&s();else for(let i=0;i<e.length;i++)Math.abs(e[i])<=_s||s()}var Tu=8192;function Io(r,e,t,n,s){let i=tt(r,n,s),o=i.tensors[e];rt(i.metadata)||y(s,n,"__metadata__ is no object"),(Object.keys(i.tensors).join()!==e||!nt(o))&&y(s,n,`not one tensor ${e}`);let[c,l,f]=o.shape,p=o.shape.length===3&&[c,l].every(_=>_>=1&&_<=Tu);(o.dtype!=="U8"||!p||!t.includes(f))&&y(s,n,`found ${o.dtype} [${o.shape}], expected U8 [H, W, ${t.join(" or ")}]`),i.data%64&&y(s,n,"data does not start at a multiple of 64");let[d]=st(r,i,[e],n,s);return{values:d,height:c,width:l,channels:f}}function To(r,e,t){let n="TRANSMITTANCE_TEXTURE",s=Io(r,"transmittance",[1,3],t,n);return e.cutoff!==void 0&&s.channels!==1&&y(n,t,"a cutoff of a coloured texture"),s}function No(r,e){return Io(r,"normals",[2],e,"NORMAL_MAP_TEXTURE")}function ys({triangles:[r,e]},t,n,s,i){r+e>n.indices.length/3&&y(`${i}_RANGE`,s,`triangles ${r} to ${r+e} of ${n.indices.length/3}`),(i==="NORMAL_MAP"||t.width*t.height>1)&&!n.uvs&&y(`${i}_UV`,s,"the mesh has no texture coordinates")}var Nu=65536,$t=class r{static async open(e){let t=new r;return t.source=e,t.directory=await $i(e),t.cache=new Map,t.manifest=wo(await t._stored(Ct)),xo(t.manifest,t.directory),t.environment=po(t.manifest),t}get poster(){return this.manifest.extensions?.RNA_poster}tier(e){let t=e?this.manifest.tiers.find(n=>n.name===e):this.manifest.tiers[0];if(!t){let n=this.manifest.tiers.map(s=>s.name).join(", ");y("TIER_UNKNOWN",this.source.name,`no tier ${e}; there are ${n}`)}return t}bytesOf(e){return this._ranges(this._needed(e,!0)).reduce((t,[n,s])=>t+s-n,0)}prefetch(e,t){this._fetch([...this.poster?[this.poster.image]:[],...this._needed(e,t)])}async load(e,{wantsLobes:t=!1}={}){let n=this.tier(e),s=this._entriesOf(n),i=new Map;this._fetch(this._needed(e,t));for(let c of s)i.set(c,await this._data(c));let o=this.manifest.parts.map((c,l)=>this._part(c,n.parts[l],l,i));return t&&this.environment&&await this._addEnvironment(o,n,i),{name:n.name,tier:n,parts:o}}async _addEnvironment(e,t,n){let s=nr(this.environment).filter(i=>!n.has(i));for(let i of s)n.set(i,await this._data(i));this.environment.forEach((i,o)=>{e[o].environment=this._environment(e[o],i,t.parts[o],n)})}_environment(e,t,n,s){let{inputs:i,lobes:o,visibility:c}=t,l=(e.mesh?.positions??e.curves.points).length/3,p=["planes","resolution","channels","planePrecision"].every(w=>t[w]===n[w])?e.planes:vs(s.get(t.planes),t,t.planes),d=c?go(s.get(c),l,c):null,_=c?Ht:0;return{inputs:i,lobes:o,harmonics:d,planes:p,...ws(s,t,t,"environment",9*o,_)}}async posterImage(){return this.poster?(this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear()}_part(e,t,n,s){let{kind:i,bounds:o,geometry:c}=e,l=`/parts/${n}`,f=s.get(c),p={name:e.name,kind:i,bounds:Ou(o),inputs:t.inputs};return i==="surface"?p.mesh=So(f,c):p.curves=Vi(f,c),p.transmittance=(e.transmittance??[]).map(d=>{let _=To(s.get(d.texture),d,d.texture);return ys(d,_,p.mesh,l,"TRANSMITTANCE"),{...d,texture:_}}),p.normalMaps=(e.normalMaps??[]).map(d=>{let _=No(s.get(d.texture),d.texture);return ys(d,_,p.mesh,l,"NORMAL_MAP"),{...d,texture:_}}),p.planes=vs(s.get(t.planes),t,t.planes),p.transport=ws(s,t,t,"transport",6),p.emission=t.emission?{inputs:t.emission.inputs,...ws(s,t,t.emission,"emission",3)}:null,p}_entriesOf(e){let t=[];for(let n of this.manifest.parts){t.push(n.geometry);for(let s of[...n.transmittance??[],...n.normalMaps??[]])t.push(s.texture)}for(let n of e.parts)t.push(n.planes,n.decoder),n.emission&&t.push(n.emission.decoder);return[...new Set(t)]}_needed(e,t){return[...new Set([...this._entriesOf(this.tier(e)),...nr(t&&this.environment||[])])]}_ranges(e){let t=e.map(s=>this.directory.get(s)).sort((s,i)=>s.header-i.header),n=[];for(let{header:s,end:i}of t){let o=n.at(-1);o&&s-o[1]<=Nu?o[1]=i:n.push([s,i])}return n}_fetch(e){let t=e.filter(s=>!this.cache.has(s)),n=this._ranges(t);if(t.length){this.source.expect(n);for(let[s,i]of n){let o=this.source.read(s,i),c=f=>f.header>=s&&f.end<=i,l=t.filter(f=>c(this.directory.get(f)));for(let f of l)this.cache.set(f,{bytes:o,start:s});o.catch(()=>l.forEach(f=>this.cache.delete(f)))}}}async _stored(e){let t=this.directory.get(e),{bytes:n,start:s}=this.cache.get(e)??{},i=n?(await n).subarray(t.header-s,t.end-s):await this.source.read(t.header,t.end);return Gi(t,i)}async _data(e){let t=await this._stored(e);await Oo(t,this.manifest.entries[e].sha256,e);let n=this.manifest.extensions?.RNA_deflate?.entries[e];if(!n)return t;let s=await uo(t,n,e);return await Oo(s,n.sha256,e),s}};function ws(r,e,t,n,s,i=0){let c={columns:t.inputs.reduce((l,f)=>l+tr(f,e.channels),i),outputs:s,output:n,precision:t.decoderPrecision};return lo(r.get(t.decoder),c,t.decoder)}function Ou({min:r,max:e}){return{min:r.map(Math.fround),max:e.map(Math.fround)}}async function Oo(r,e,t){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",r))].map(i=>i.toString(16).padStart(2,"0")).join("")!==e&&y("ENTRY_HASH",t,"the bytes do not have the declared SHA-256")}var Mu=["maxStorageBufferBindingSize","maxBufferSize"];async function Mo(){let r=await navigator.gpu?.requestAdapter({powerPreference:"high-performance"});if(!r){let t=navigator.gpu?"WebGPU has no adapter here":isSecureContext?"this browser has no WebGPU":"WebGPU needs HTTPS, or a page from this machine";throw new G(`${t}: only the poster is shown`)}let e=Object.fromEntries(Mu.map(t=>[t,r.limits[t]]));return r.requestDevice({requiredLimits:e})}function ne(r,e,t=GPUBufferUsage.STORAGE,n="a buffer"){let s=typeof e=="number"?e:e.byteLength,i=Math.max(16,Math.ceil(s/16)*16),o=r.limits.maxStorageBufferBindingSize;if(i>o)throw new G(`${n} takes ${ht(i)}; this GPU allows ${ht(o)}`);let c=r.createBuffer({size:i,usage:t|GPUBufferUsage.COPY_DST|GPUBufferUsage.COPY_SRC,mappedAtCreation:typeof e!="number"});if(typeof e!="number"){let l=new Uint8Array(e.buffer,e.byteOffset,e.byteLength);new Uint8Array(c.getMappedRange()).set(l),c.unmap()}return c}async function sr(r,e){let t=r.createShaderModule({code:e}),{messages:n}=await t.getCompilationInfo(),s=n.find(({type:i})=>i==="error");if(s)throw new Error(`a shader does not compile, line ${s.lineNum}: ${s.message}`);return t}var gn=(r,e,t,n)=>Fe(r,e.getBindGroupLayout(t),n);function Ie(r,e){let t=Object.entries(e).map(([n,s])=>({binding:Number(n),visibility:GPUShaderStage.COMPUTE,buffer:{type:s}}));return r.createBindGroupLayout({entries:t})}function Fe(r,e,t){let n=Object.entries(t).map(([s,i])=>({binding:Number(s),resource:{buffer:i}}));return r.createBindGroup({layout:e,entries:n})}function fe(r,e,t,n){let s=Math.max(1,Math.ceil(n/64)),i=Math.min(s,32768);r.setPipeline(e),t.forEach((o,c)=>r.setBindGroup(c,o)),r.dispatchWorkgroups(i,Math.ceil(s/i))}async function _n(r,e,t){let n=r.createBuffer({size:Math.ceil(t/4)*4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST}),s=r.createCommandEncoder();s.copyBufferToBuffer(e,0,n,0,n.size),r.queue.submit([s.finish()]),await n.mapAsync(GPUMapMode.READ);let i=n.getMappedRange().slice(0);return n.destroy(),i}var Lu={position:[0,0,0],corner:[0,0,0],stepX:[0,0,0],stepY:[0,0,0]};async function Lo(r,e,t,n,s=!0){let i=r.parts[e][t],{device:o,queue:c,bandPixels:l}=r,f=t==="transport"?2:1,p=n.length/16,d=new Float32Array(3*f*p);for(let _=0;_<p;_+=l){let w=Math.min(l,p-_);if(o.queue.writeBuffer(c.rows,0,n,16*_,16*w),o.queue.writeBuffer(c.count,0,Uint32Array.of(w)),r._run(R=>i.run(R,c,w)),await r.done(),!s)continue;let A=new Float32Array(await _n(o,c.answers,16*f*w));for(let R=0;R<f*w;R++)d.set(A.subarray(4*R,4*R+3),3*(f*_+R))}return d}async function Po(r,e,t,n){let{device:s,band:i}=r,{words:o,members:c}=_e.Pixel,l=new Uint32Array(o*e.length);e.forEach(({place:p,b1:d,b2:_,x:w,wi:A,part:R},L)=>{let H=(Z,K)=>[...new Uint32Array(Float32Array.from(Z).buffer),K];l.set(ae("Pixel",{position:H(w,0),axis:[0,0,0,R+1],wo:[0,0,0,p],wi:H(A,0),b1:d,b2:_}),o*L)}),r.resize(e.length,1),r.span={first:0,pixels:e.length,jitter:0},s.queue.writeBuffer(i,0,l),r._writeFrame(Lu,0),r._writeView({kind:"given",colour:[1,1,1]}),r._run(p=>fe(p,t,r.groups.rays,e.length));let f=new Float32Array(await _n(s,i,l.byteLength));return Float32Array.from({length:3*e.length},(p,d)=>f[o*Math.floor(d/3)+c[n].at+d%3])}var Fo=(r,e)=>Po(r,e,r.kernels.light,"visibility");async function Co(r,e){let t=await r.pipelines.get(r.raySources.hit,"find_normals",r.rayLayout);return Po(r,e,t,"axis")}var xs=r=>Uint8Array.from(atob(r),e=>e.charCodeAt(0));function bs(r){let e=new Uint8Array(r.buffer,r.byteOffset,r.byteLength),t="";for(let n=0;n<e.length;n+=8192)t+=String.fromCharCode(...e.subarray(n,n+8192));return btoa(t)}var ir=class{constructor(e){this.engine=e}async load(e,t){let n=await $t.open(new Et(new Blob([xs(e)]),"package"));this.shown=await n.load(t),this.arrays=await Yn(this.shown.parts),await this.engine.setAsset(this.arrays,this.shown.parts),this.engine.resize(1,1)}async evaluate(e,t,n){let s=t==="transport"?13:10,i=new Float32Array(xs(n).buffer),o=new Float32Array(16*i.length/s);for(let c=0;16*c<o.length;c++){let l=i.subarray(s*c,s*(c+1)),f=l.subarray(7,10);o.set([...l.subarray(0,3),l[6],...l.subarray(3,6),0,...f,0,...s===13?l.subarray(10):f],16*c)}return bs(await this.answer(e,t,o))}answer(...e){return Lo(this.engine,...e)}async visibility(e){return bs(await Fo(this.engine,this._hits(e)))}async normals(e){return bs(await Co(this.engine,this._hits(e)))}_hits(e){let{buffer:t}=xs(e),n=new Uint32Array(t),s=new Float32Array(t),i=[];for(let o=0;o<n.length;o+=8){let c=n[o+7],{first:l,fiber:f}=this.arrays.parts[c],p=s.subarray(o,o+7),d=this.arrays.where[l+n[o]];i.push(f?{place:d,part:c,b1:0,b2:0,x:p.slice(1,4),wi:p.slice(4,7)}:{place:d,part:c,b1:p[1],b2:p[2],x:[0,0,0],wi:p.slice(3,6)})}return i}};var qt=.4*Math.PI/180,Gt=5*Math.PI/180;function zo(r,e,t=()=>!0){let n=new Map,s=null;r.addEventListener("pointerdown",o=>{t(o)&&(n.set(o.pointerId,{x:o.clientX,y:o.clientY}),Pu(r,o.pointerId),r.classList.add("dragging"),n.size===2?s="two":n.size===1&&(s=o.button===2?"pan":o.button!==0?null:o.altKey||o.shiftKey?"light":"orbit"))}),r.addEventListener("pointermove",o=>{let c=n.get(o.pointerId);if(!c)return;let l={x:o.clientX,y:o.clientY},f=l.x-c.x,p=l.y-c.y;s==="two"&&Fu(n,o.pointerId,c,l,e),n.set(o.pointerId,l),!(!f&&!p)&&(s==="orbit"&&e.orbit(-f*qt,p*qt,!0),s==="light"&&e.light(f*qt,-p*qt,!0),s==="pan"&&e.pan(-f/r.clientHeight,p/r.clientHeight,!0))});for(let o of["pointerup","pointercancel"])r.addEventListener(o,c=>{n.delete(c.pointerId)&&(n.size||(s=null,r.classList.remove("dragging"),e.settle()))});r.addEventListener("contextmenu",o=>t(o)&&o.preventDefault()),r.addEventListener("dblclick",o=>t(o)&&e.reset());let i=0;r.addEventListener("wheel",o=>{if(!t(o))return;o.preventDefault();let c=o.deltaMode===0?o.deltaY:o.deltaY*32;e.zoom(Math.exp(Math.min(300,Math.max(-300,c))*.0012),!0),clearTimeout(i),i=setTimeout(()=>e.settle(),200)},{passive:!1}),r.addEventListener("keydown",o=>t(o)&&Cu(o,e))}function Pu(r,e){try{r.setPointerCapture(e)}catch{}}function Fu(r,e,t,n,s){let i=[...r].find(([c])=>c!==e)?.[1];if(!i)return;let o=c=>Math.hypot(c.x-i.x,c.y-i.y)||1;s.zoom(o(t)/o(n),!0),s.light(.5*(n.x-t.x)*qt,-.5*(n.y-t.y)*qt,!0)}function Cu(r,e){if(r.ctrlKey||r.metaKey)return;let t=r.altKey||r.shiftKey?e.light:e.orbit,n={ArrowLeft:()=>t(-Gt,0),ArrowRight:()=>t(Gt,0),ArrowUp:()=>t(0,Gt),ArrowDown:()=>t(0,-Gt),"+":()=>e.zoom(1/1.1),"=":()=>e.zoom(1/1.1),"-":()=>e.zoom(1.1),"[":()=>e.light(-Gt,0),"]":()=>e.light(Gt,0),Home:()=>e.reset()};Object.hasOwn(n,r.key)&&(r.preventDefault(),n[r.key]())}var{RNA_NONE:$o,MAX_LAYERS:Uo,MAX_EXACT_INPUTS:Do,RNA_CHANNEL_GROUPS:Ho}=ce,jt=r=>Math.ceil(r/4);function ar(r,e,t,n=0){zu(e);let{places:s,slots:i,queryGroups:o}=Uu(t,r.planes.channels,n),c=new As,l=$o;e.int8&&(l=c.add(or(e.gain,s,o)),c.add(or(e.offset,s,o)));let f=e.layers.map((A,R)=>Bo(c,A,R?null:s,R?0:o)),p=null;if(e.matrix){let A=e.matrix.length/e.outputs,R=new Float32Array(e.outputs);p=Bo(c,{weight:e.matrix,bias:R,rows:A,columns:e.outputs,relu:!1},null,0)}let d=[...f,...p?[p]:[]],_=Math.max(...d.flatMap(({inputs:A,outputs:R})=>[A,R])),w=Du(r,e,{queryGroups:o,gain:l,slots:i,layers:f,matrix:p});return{weights:c.all(),record:w,groups:Math.max(4,2**Math.ceil(Math.log2(_)))}}function zu({layers:r,int8:e}){if(r.length>Uo)throw new G(`a decoder of ${r.length} layers; at most ${Uo}`);let t=e?Math.max(...r.map(({rows:n})=>n)):0;if(t>Do)throw new G(`an int8 layer of ${t} inputs; at most ${Do}`)}function Uu(r,e,t){let n=[],s=er.map(()=>$o),i=0;for(let o of r){let c=tr(o,e);s[er.indexOf(pt(o))]=i;for(let l=0;l<c;l++)n.push(4*i+l);i+=jt(c)}for(let o=0;o<t;o++)n.push(4*i+o);return i+=jt(t),{places:n,slots:s,queryGroups:i}}var As=class{constructor(){this.list=[],this.length=0}add(e){let t=this.length;return this.list.push(e),this.length+=e.length/4,t}all(){let e=new Float32Array(4*this.length),t=0;for(let n of this.list)e.set(n,t),t+=n.length;return e}};function or(r,e,t){let n=new Float32Array(4*t);return r.forEach((s,i)=>{n[e?e[i]:i]=s}),n}function Bo(r,{weight:e,bias:t,rows:n,columns:s,step:i=0,scales:o,relu:c},l,f){let p=f||jt(n),d=jt(s),_=new Float32Array(16*p*d);for(let L=0;L<n;L++){let H=l?l[L]:L,Z=H>>2;for(let K=0;K<s;K++)_[16*((K>>2)*p+Z)+4*(H&3)+(K&3)]=e[L*s+K]}let w=r.add(_),A=r.add(or(t,null,d)),R=o?r.add(or(Float32Array.from(o,L=>L*i),null,d)):0;return{inputs:p,outputs:d,weights:w,bias:A,units:R,relu:Number(c),int8_step:i}}function Du(r,e,{queryGroups:t,gain:n,slots:s,layers:i,matrix:o}){let{resolution:c,channels:l,precision:f,scales:p}=r.planes,{low:d,high:_,top:w,unit:A}=e,R=new Float32Array(12*Ho);for(let L=0;p&&L<3;L++)R.set(p.subarray(L*l,(L+1)*l),4*Ho*L);return ae("RnaPart",{low:r.bounds.min,high:r.bounds.max,resolution:c,channel_groups:jt(l),query_groups:t,layer_count:i.length,plane_precision:ce[`RNA_${f.toUpperCase()}`],gain:n,query_low:d,query_high:_,top:w,unit:A,matrix:o??{},scales:R,layers:i,slots:s})}function Go({values:r,resolution:e,channels:t},n){let s=e*e,i=r.subarray(n*s*t,(n+1)*s*t),o=4*jt(t);if(o===t)return i;let c=new r.constructor(s*o);for(let l=0;l<s;l++)c.set(i.subarray(l*t,(l+1)*t),l*o);return c}var gt={surface:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","surface_blocks.wgsl","decoder.wgsl","surface.wgsl"],fiber:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","fiber_blocks.wgsl","decoder.wgsl","fiber.wgsl"],evaluate:["row_records.wgsl","arguments.wgsl","evaluate.wgsl"],"render/step":["render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl","render/sampler.wgsl"],"render/scene":["render/step","geometry_records.wgsl","geometry.wgsl","segment.wgsl","normal_maps.wgsl","visibility.wgsl","render/surfaces.wgsl","render/textures.wgsl","render/transmittance.wgsl","render/bumps.wgsl","render/vertex.wgsl"],"render/lit":["render/directions.wgsl","render/lights.wgsl","render/environment.wgsl","render/triangle_lights.wgsl"],"render/traced":["triangle.wgsl","bvh.wgsl","render/light_shapes.wgsl","render/passing.wgsl","render/tracing.wgsl"],rays:["render/scene","triangle.wgsl","bvh.wgsl","render/passing.wgsl","render/tracing.wgsl"],hit:["rays"],light:["rays","render/lit","render/light_shapes.wgsl","render/lobe_constants.wgsl"],columns:["geometry_records.wgsl","queue"],queue:["row_records.wgsl","render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl"]},ct={"arguments.wgsl":`// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
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
    let v = vec3f(
        rna_scaled(bits.x, largest), rna_scaled(bits.y, largest), rna_scaled(bits.z, largest),
    );
    let square = dot(v, v);
    if square == 0.0 {
        return vec3f(0.0);
    }
    return v / sqrt(square);
}
`,"blocks.wgsl":`// Input blocks that surfaces and fibers share: spec/RNA.md, 6.3 Input blocks. Each block starts at
// a group of 4 columns of its own; the packer has spread the rows of the first matrix likewise.

// First group of an input block, RNA_NONE where the decoder does not have it.
fn rna_slot(block: u32) -> u32 {
    return rna_part.slots[block / 4u][block % 4u];
}

fn rna_put(slot: u32, values: vec4f) {
    if slot != RNA_NONE {
        rna_values[slot] = values;
    }
}

// Writes \`features\`, \`position\`, \`wo\` and \`wi\`; returns the first three features.
fn rna_common_blocks(x: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let p = rna_relative(x);
    let texels = rna_texels(p);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    let groups = select(rna_part.channel_groups, 1u, slot == RNA_NONE);
    var first = vec4f(0.0);
    for (var group = 0u; group < groups; group++) {
        let features = rna_features(texels, group);
        first = select(first, features, group == 0u);
        rna_put(select(slot + group, RNA_NONE, slot == RNA_NONE), features);
    }
    rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    return first.xyz;
}

// Halfway between wo and wi, 0 where they are opposite, for a vector across n, q and wi ("In
// float32": the difference of their lengths goes).
fn rna_halfway(wo: vec3f, wi: vec3f) -> vec3f {
    var s = wi + wo;
    let e = wi - wo;
    let square = dot(e, e);
    if dot(s, s) < square {
        s -= e * (dot(s, e) / square);
    }
    let size = length(s);
    if size < 1e-6 {
        return vec3f(0.0);
    }
    return s / size;
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
        let found = rna_meet_triangle(
            line, rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
        );
        if found.x >= RNA_FAR || !rna_stops(primitive, ray, found, (*hit).instance) {
            return false;
        }
        *hit = RnaHit(found.x, (*hit).instance, primitive, found.y, found.z, vec3f(0.0));
        return true;
    }
    if rna_strand(record) == start_strand {
        return false;
    }
    let entry = rna_meet_segment(line, record);
    if entry.t >= RNA_FAR {
        return false;
    }
    *hit = RnaHit(entry.t, (*hit).instance, primitive, 0.0, 0.0, entry.normal);
    return true;
}

// The closest hit of a body below \`root\`, ray in its object space, nearer than \`hit\`; with \`any\`
// the first that is found.
fn rna_trace_body(
    root: u32, ray: RnaRay, start_strand: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    var top = RNA_STACK;
    var node = root;
    var found = false;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, (*hit).t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_meet(first + k, ray, start_strand, hit) {
                found = true;
                if any {
                    return true;
                }
            }
        }
        if next == RNA_NOTHING {
            if top == RNA_STACK {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return found;
}

// Tests an instance, world ray; \`own\` is passed through, and so is what \`rays\` has no bit of.
fn rna_trace_instance(
    instance: u32, ray: RnaRay, own: u32, rays: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    if instance == own || (rna_instances[instance].rays & rays) == 0u {
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
fn rna_trace(ray: RnaRay, own: u32, rays: u32, any: bool) -> RnaHit {
    var hit = rna_miss(ray.far);
    var top = 0u;
    var node = 0u;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, hit.t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_trace_instance(first + k, ray, own, rays, any, &hit) && any {
                return hit;
            }
        }
        if next == RNA_NOTHING {
            if top == 0u {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return hit;
}
`,"decoder.wgsl":`// The decoder: spec/RNA.md, 6.4 Decoder profile. All loops take their lengths from RnaPart: shaders
// that are unrolled take minutes to compile. Drivers inline each call: one call, in a loop, compiles
// sooner than two.

struct RnaTransport {
    visible: vec3f, // of emission: what is emitted
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
    var o = 0u;
    for (; o + 4u <= layer.outputs; o += 4u) {
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
        rna_finish(layer, o, a, place);
        rna_finish(layer, o + 1u, b, place);
        rna_finish(layer, o + 2u, c, place);
        rna_finish(layer, o + 3u, d, place);
    }
    for (; o < layer.outputs; o++) {
        var sums = vec4f(0.0);
        for (var k = 0u; k < layer.inputs; k++) {
            sums += rna_block(rna_values[source + k], layer.weights + o * stride + 4u * k);
        }
        rna_finish(layer, o, sums, place);
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

// The colours for the queries in rna_values.
fn rna_decode() -> RnaTransport {
    let source = rna_run_decoder();
    let first = rna_values[source];
    let second = rna_values[source + 1u];
    let visible = max(first.xyz, vec3f(0.0));
    return RnaTransport(visible, max(vec3f(first.w, second.xy), vec3f(0.0)));
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
    let x = rna_values[place + k / 4u][k % 4u];
    let y = rna_values[place + (k + 1u) / 4u][(k + 1u) % 4u];
    let z = rna_values[place + (k + 2u) / 4u][(k + 2u) % 4u];
    return max(vec3f(x, y, z), vec3f(0.0));
}

// Lobe j. free: the asset's own visibility along m.
fn rna_lobe(place: u32, j: u32, axis: vec3f, wo: vec3f, m: vec3f, free: f32) -> RnaLobe {
    var base = RNA_SHARP * m;
    if j < RNA_LOBES / 2u {
        base = RNA_WIDE * select(axis, -wo, RNA_IS_FIBER == 1u);
    }
    let a = rna_three(place, 9u * j + 6u) - RNA_AXIS_SHIFT + base;
    let amplitude = mix(rna_three(place, 9u * j + 3u), rna_three(place, 9u * j), free);
    return RnaLobe(amplitude, max(length(a), RNA_LEAST_KAPPA), a);
}
`,"evaluate.wgsl":`// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read_write> rna_results: array<vec4f>;
@group(1) @binding(2) var<storage, read> rna_row_count: array<u32>; // [0]

// RNA_COLOURS, 2 of transport and 1 of emission, is declared by whoever composes the files.
fn rna_write(row: u32, result: RnaTransport) {
    rna_results[RNA_COLOURS * row] = vec4f(result.visible, 0.0);
    if RNA_COLOURS == 2u {
        rna_results[2u * row + 1u] = vec4f(result.shadowed, 0.0);
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
    let a = rna_unit(at.axis);
    let o = rna_unit(at.wo);
    let i = rna_unit(at.wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        result = rna_query(bitcast<vec3f>(at.position), a, bitcast<f32>(at.h), o, i);
    }
    rna_write(row, result);
}
`,"fiber.wgsl":`// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, t, h, wo, wi, wi);
    return rna_decode();
}

// The last argument is the half vector of surfaces.
fn rna_put_queries(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f, m: vec3f) {
    rna_common_blocks(x, wo, wi);
    rna_fiber_blocks(t, clamp(h, -1.0, 1.0), wo, wi);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_fiber(x, axis, h, wo, wi);
}
`,"fiber_blocks.wgsl":`// Input blocks of fibers alone: spec/RNA.md, 6.3 Input blocks and "In float32".

const RNA_ETA: f32 = 1.55;

// c_o, cos phi and sin phi. Products with t have lost the component along it: t x wo and t x wi
// have the lengths c_o and c_i, and phi is between them.
fn rna_azimuth(t: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let o = cross(t, wo);
    let i = cross(t, wi);
    let c_o = length(o);
    let d = c_o * length(i);
    if d < 1e-6 {
        return vec3f(c_o, 1.0, 0.0);
    }
    return vec3f(c_o, clamp(dot(o, i) / d, -1.0, 1.0), clamp(dot(t, cross(o, i)) / d, -1.0, 1.0));
}

// Cosine and sine of twice the angle within 90 degrees that has this sine.
fn rna_doubled(sine: f32) -> vec2f {
    let cosine = sqrt(max(0.0, (1.0 - sine) * (1.0 + sine)));
    return vec2f(1.0 - 2.0 * sine * sine, 2.0 * sine * cosine);
}

// cos(phi - Phi_p) for p = 0, 1, 2, by the addition theorems; each segment turns by -2 g_t - pi.
fn rna_lobes(h: f32, s_o: f32, azimuth: vec3f) -> vec3f {
    let segment = rna_doubled(h * azimuth.x / sqrt(RNA_ETA * RNA_ETA - s_o * s_o));
    let r = rna_doubled(h);
    let tt = vec2f(-r.x * segment.x - r.y * segment.y, r.x * segment.y - r.y * segment.x);
    let trt = vec2f(-tt.x * segment.x - tt.y * segment.y, tt.x * segment.y - tt.y * segment.x);
    let phi = azimuth.yz;
    return vec3f(dot(phi, r), dot(phi, tt), dot(phi, trt));
}

fn rna_fiber_blocks(t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_TANGENT), vec4f(t, 0.0));
    rna_put(rna_slot(RNA_BLOCK_H), vec4f(h, 0.0, 0.0, 0.0));
    let angles = rna_slot(RNA_BLOCK_FIBER_ANGLES);
    let lobes = rna_slot(RNA_BLOCK_FIBER_LOBES);
    if angles == RNA_NONE && lobes == RNA_NONE {
        return;
    }
    let s_o = dot(t, wo);
    let s_i = dot(t, wi);
    let cone = s_i + s_o;
    let azimuth = rna_azimuth(t, wo, wi);
    if angles != RNA_NONE {
        rna_values[angles] = vec4f(s_i, s_o, cone, log2(cone * cone + 1e-3) / 6.0);
        rna_values[angles + 1u] = vec4f(azimuth.yz, 0.0, 0.0);
    }
    rna_put(lobes, vec4f(rna_lobes(h, s_o, azimuth), 0.0));
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
    b1: f32, // barycentric coordinates of a triangle's second and third corner
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
    own: u32, // 124; a number of the host's
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

struct RnaPart { // 1936 bytes
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
    matrix: RnaLayer, // 64; [n, 6], with a bias of 0; all 0 without
    scales: array<vec4f, 48>, // 96; of int8 planes, [plane][group]
    layers: array<RnaLayer, 32>, // 864
    slots: array<vec4<u32>, 3>, // 1888; first group of each block, RNA_NONE for none: see rna_slot
}
`,"planes.wgsl":`// Features of a position: spec/RNA.md, 5 Planes.

fn rna_plane_word(plane: u32, at: u32) -> u32 {
    switch plane {
        case 0u: { return rna_plane_xy[at]; }
        case 1u: { return rna_plane_yz[at]; }
        default: { return rna_plane_zx[at]; }
    }
}

// The value of a float16; drivers may take subnormal ones for 0, the format does not.
fn rna_from_float16(bits: u32) -> f32 {
    let exponent = (bits >> 10u) & 31u;
    let mantissa = bits & 1023u;
    let size = select(
        bitcast<f32>(((exponent + 112u) << 23u) | (mantissa << 13u)),
        f32(mantissa) * 0x1p-24f,
        exponent == 0u,
    );
    return select(size, -size, (bits & 0x8000u) != 0u);
}

// Channels 4 group to 4 group + 3 of a texel; texel = row * resolution + column.
fn rna_texel(plane: u32, texel: u32, group: u32) -> vec4f {
    let at = texel * rna_part.channel_groups + group;
    switch rna_part.plane_precision {
        case RNA_FLOAT32: {
            return vec4f(
                bitcast<f32>(rna_plane_word(plane, 4u * at)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 1u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 2u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 3u)),
            );
        }
        case RNA_FLOAT16: {
            let a = rna_plane_word(plane, 2u * at);
            let b = rna_plane_word(plane, 2u * at + 1u);
            return vec4f(
                rna_from_float16(a & 0xffffu),
                rna_from_float16(a >> 16u),
                rna_from_float16(b & 0xffffu),
                rna_from_float16(b >> 16u),
            );
        }
        default: {
            let word = bitcast<i32>(rna_plane_word(plane, at));
            let integers = vec4<i32>(word << 24u, word << 16u, word << 8u, word) >> vec4<u32>(24u);
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
    let lower = rows.x * rna_part.resolution;
    let upper = rows.y * rna_part.resolution;
    let at_lower = (1.0 - a) * rna_texel(plane, lower + columns.x, group)
        + a * rna_texel(plane, lower + columns.y, group);
    let at_upper = (1.0 - a) * rna_texel(plane, upper + columns.x, group)
        + a * rna_texel(plane, upper + columns.y, group);
    return (1.0 - b) * at_lower + b * at_upper;
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
    let own = select(-side, side, dot(m, g) >= 0.0);
    return own * raised_above(own * bent, side * g, o);
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
    let a = image_texel(light, upper, column);
    let b = image_texel(light, upper, right);
    let c = image_texel(light, lower, column);
    let d = image_texel(light, lower, right);
    return Cell(
        mat4x3f(a, b, c, d), vec4f(luminance(a), luminance(b), luminance(c), luminance(d)),
    );
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
`,"render/light_shapes.wgsl":`// Lights with a shape, which rays meet.

// The hit, or a nearer one of a light with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    var hit = found;
    for (var light = 0u; light < frame.light_count; light++) {
        let hidden = frame.rays == CAMERA_RAY && !light_is(light, LIGHT_SEEN);
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
`,"render/lobe_constants.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const SURFACE_SHARES = vec3f(0.2, 0.35, 0.45);
const FIBER_SHARES = vec3f(0.3, 0.45, 0.25);
const MIRROR_KAPPA: f32 = 20.0;
const CONE_SCALE: f32 = 0.06;
const FORWARD_KAPPA: f32 = 5.0;
`,"render/passing.wgsl":`// What rays pass through: rna_trace/embree/filters.py. Rays pass hits at random, as often as these
// let light through; shadow rays pass all and are weakened.

const ALL_STOP: u32 = 0u;
const AT_RANDOM: u32 = 1u; // the mean of the colours
const WEAKEN: u32 = 2u;
const WEIGH: u32 = 3u; // stops at nothing; colour over mean of what AT_RANDOM has passed

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

fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool {
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
    let tau = transmittance(record, found.y, found.z, ray.direction, facing);
    if passing == WEAKEN {
        passed_weight *= tau;
        return all(passed_weight <= vec3f(0.0));
    }
    let mean = (tau.x + tau.y + tau.z) / 3.0;
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
const SHADOW_RAY: u32 = 4u;
const ALL_DIRECTIONS: u32 = 0xffffffffu;
const HEMISPHERE: u32 = 0xfffffffeu;
const CHOICES: u32 = 1u;
const DIRECTION: u32 = 2u;
const ROULETTE: u32 = 3u;
const LIGHT: u32 = 4u;
const DIMENSIONS: u32 = 7u;
const HAS_SKY: u32 = 1u;
const FOR_BETA: u32 = 2u;
const RAYS_MEET_LIGHTS: u32 = 4u;
const FOR_EMISSION: u32 = 8u;
const FOR_LIGHT: u32 = 16u;
const TRANSMITS: u32 = 32u;

struct Frame { // 160 bytes
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
    own: u32, // 72; instance that the ray passes through
    b1: f32, // 76
    leaving: vec3f, // 80; of a ray that leaves an asset: its start in object space
    b2: f32, // 92
}

struct Query { // 96 bytes
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
    reserved: u32, // 92
}

struct PathQueries { // 192 bytes
    at_point: Query, // 0; what the path's point scatters or emits
    at_light: Query, // 96; what an asset emits at its point that was sampled as a light
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

fn weights_of(b1: f32, b2: f32) -> vec3f {
    return vec3f(1.0 - b1 - b2, b1, b2);
}
`,"render/table_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const OF_MATERIAL: u32 = 0u;
const OF_NEURAL: u32 = 1u;
const OF_FIBERS: u32 = 2u;
const EMITS: u32 = 1u;
const LETS_THROUGH: u32 = 2u;
const IS_GLASS: u32 = 4u;
const HAS_CUTOFF: u32 = 8u;
const HAS_SCHLICK: u32 = 16u;
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
fn object_step(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].z;
}
fn object_passes(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].w);
}

fn surface_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].x);
}
fn surface_part(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].y);
}
fn surface_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].z);
}
fn surface_normal_map(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].w);
}
fn surface_base_color(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 1u].xyz;
}
fn surface_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 1u].w;
}
fn surface_metallic(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].x;
}
fn surface_coat_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].y;
}
fn surface_coat_weight(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].z;
}
fn surface_transmission(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].w;
}
fn surface_emission(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 3u].xyz;
}
fn surface_normal_scale(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 3u].w;
}
fn surface_clear_coat(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].x;
}
fn surface_clear_coat_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].y;
}
fn surface_second_uvs(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].z);
}
fn surface_tangents(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].w);
}
fn surface_textures(k: u32, i: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 5u + i / 4u][i % 4u]);
}
fn surface_through(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 7u].x);
}
fn surface_cutoff(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 7u].y;
}
fn surface_ior(k: u32) -> vec2f {
    return table[frame.surfaces + 9u * k + 7u].zw;
}
fn surface_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 8u].x;
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
`,"render/textures.wgsl":`// Textures on triangles: rna_render/materials/textures.py. A texel is a u32 of three bytes.

const REPEAT: u32 = 0u;
const MIRROR: u32 = 2u;

struct Image {
    place: u32,
    size: vec2<u32>, // columns, rows
    form: u32,
}

fn image_of(texture: u32) -> Image {
    let size = texture_size(texture);
    return Image(
        texture_place(texture), vec2<u32>(size & 0xffffu, size >> 16u), texture_form(texture),
    );
}

fn texel(at: Image, column: u32, row: u32) -> vec3f {
    let word = images[at.place + row * at.size.x + column];
    let c = vec3f((vec3<u32>(word) >> vec3<u32>(0u, 8u, 16u)) & vec3<u32>(255u)) / 255.0;
    if (at.form & 16u) == 0u {
        return c;
    }
    return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

struct Around {
    first: u32,
    second: u32,
    part: f32,
}

// The two texels whose centres x is between.
fn texels_around(x: f32, size: u32, wrap: u32) -> Around {
    var inside = clamp(x, 0.0, 1.0);
    if wrap == REPEAT {
        inside = x - floor(x);
    } else if wrap == MIRROR {
        let twice = x - 2.0 * floor(0.5 * x);
        inside = select(twice, 2.0 - twice, twice > 1.0);
    }
    let place = inside * f32(size) - 0.5;
    let low = floor(place);
    let first = i32(low);
    let last = i32(size) - 1;
    if wrap == REPEAT {
        let wrapped = select(first, last, first < 0);
        return Around(u32(wrapped), u32(select(first + 1, 0, first + 1 > last)), place - low);
    }
    return Around(u32(max(first, 0)), u32(min(first + 1, last)), place - low);
}

// Bilinear, mixed after decoding, at the mesh's coordinates.
fn texture_value(texture: u32, uv: vec2f) -> vec3f {
    let at = image_of(texture);
    let u = dot(texture_row_u(texture), vec3f(uv, 1.0));
    let v = dot(texture_row_v(texture), vec3f(uv, 1.0));
    let x = texels_around(u, at.size.x, at.form & 3u);
    let y = texels_around(v, at.size.y, (at.form >> 2u) & 3u);
    let upper = mix(texel(at, x.first, y.first), texel(at, x.second, y.first), x.part);
    let lower = mix(texel(at, x.first, y.second), texel(at, x.second, y.second), x.part);
    return mix(upper, lower, y.part);
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
//     fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit
// where there are none.

struct Through {
    hit: RnaHit,
    weight: vec3f, // for what the ray passed or hit at random, if that has a colour
}

// The closest hit of a camera or indirect ray; \`key\` decides what it passes.
fn closest_through(ray: RnaRay, own: u32, key: u32) -> Through {
    var hit = rna_miss(ray.far);
    var line = ray;
    var share = vec3f(1.0);
    chance_key = key;
    stopped_share = vec3f(1.0);
    start_passing(AT_RANDOM);
    loop {
        let found = rna_trace(line, own, frame.rays, false);
        if passing == WEIGH {
            break;
        }
        hit = with_lights(ray, found);
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
fn visible_on(ray: RnaRay, own: u32) -> vec3f {
    start_passing(WEAKEN);
    var hit = rna_trace(ray, own, frame.rays, true);
    if hit.instance == RNA_NOTHING {
        hit = with_lights(ray, hit);
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

fn segment_vertex(path: Path, record: RnaPrimitive, wo: vec3f) -> Vertex {
    var v: Vertex;
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    let size = max(abs(way.x), max(abs(way.y), abs(way.z)));
    v.axis = normalize(way / size);
    v.n = path.normal;
    v.ng = path.normal;
    v.x = path.t * rna_object_direction(path.direction, path.instance)
        / rna_instances[path.instance].scale
        + rna_object_point(path.origin, path.instance);
    v.x = on_cone(cone, v.x, v.n);
    let across = cross(v.axis, wo);
    let width = length(across);
    if width > 1e-6 {
        v.h = clamp(dot(v.n, across) / width, -1.0, 1.0);
    }
    v.shading = v.n;
    v.strand = rna_strand(record);
    return v;
}

// The point of the surface of normal n near x: that of the sphere which touches it there. The error
// of x is that of its ray's length.
fn on_cone(cone: RnaCone, x: vec3f, n: vec3f) -> vec3f {
    let way = cone.b - cone.a;
    let radius = dot(x - cone.a, n);
    let along = dot(x - cone.a - clamp(radius, 0.0, max(cone.ra, cone.rb)) * n, way);
    let u = clamp(along / dot(way, way), 0.0, 1.0);
    return mix(cone.a, cone.b, u) + mix(cone.ra, cone.rb, u) * n;
}

fn vertex_of(path: Path) -> Vertex {
    let record = rna_primitives[path.primitive];
    let wo = rna_object_direction(-path.direction, path.instance);
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, path.b1, path.b2);
    } else {
        v = segment_vertex(path, record, wo);
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
    v.x_world = rna_world_point(v.x, path.instance);
    v.n_world = rna_world_direction(v.shading, path.instance);
    v.ng_world = rna_world_direction(v.ng, path.instance);
    return v;
}

// Where rays along wi start in the world: on materials a step off the surface.
fn origin_of(v: Vertex, wi_world: vec3f) -> vec3f {
    let step = object_step(v.instance);
    return v.x_world + select(step, -step, dot(v.ng_world, wi_world) < 0.0) * v.ng_world;
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
`,"row_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

struct RnaRow { // 64 bytes
    position: vec3<u32>, // 0; object space
    h: u32, // 12
    axis: vec3<u32>, // 16; normal or tangent
    reserved: u32, // 28
    wo: vec3<u32>, // 32
    reserved_2: u32, // 44
    wi: vec3<u32>, // 48
    reserved_3: u32, // 60
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
    normal: vec3f,
}

// The entry of the line into the cone: of the points where it enters a sphere at an end, or the side
// between them, the first. \`from\` is near the cone, to keep digits.
fn rna_enter_cone(cone: RnaCone, p: vec3f, d: vec3f) -> RnaEntry {
    let ta = rna_enter_sphere(p, d, cone.a, cone.ra);
    let tb = rna_enter_sphere(p, d, cone.b, cone.rb);
    var entry = RnaEntry(min(ta, tb), vec3f(0.0));
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
            entry = RnaEntry(side, normal);
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
    let miss = RnaEntry(RNA_FAR, vec3f(0.0));
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
    return RnaEntry(t, normalize(entry.normal));
}
`,"surface.wgsl":`// Transport, or emission, at a point of a surface: spec/RNA.md, 7 Light.

// x: object space, metres. n, wo, wi: unit, away from the surface; all finite. An emission decoder
// reads no wi.
fn rna_surface(x: vec3f, n: vec3f, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, n, 0.0, wo, wi, rna_halfway(wo, wi));
    return rna_decode();
}

// m: the half vector.
fn rna_put_queries(x: vec3f, n: vec3f, h: f32, wo: vec3f, wi: vec3f, m: vec3f) {
    let features = rna_common_blocks(x, wo, wi);
    rna_surface_blocks(n, features, wo, wi, m);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_surface(x, axis, wo, wi);
}
`,"surface_blocks.wgsl":`// Input blocks of surfaces alone: spec/RNA.md, 6.3 Input blocks and "In float32".

// log2(1 - min(n.m, 1) + 1e-4) / 6; m: unit, or 0 for one across n
fn rna_log_gap(n: vec3f, m: vec3f) -> f32 {
    let gap = n - m;
    return log2(select(0.5 * dot(gap, gap), 1.0, all(m == vec3f(0.0))) + 1e-4) / 6.0;
}

fn rna_half_vector(slot: u32, n: vec3f, m: vec3f, wo: vec3f, wi: vec3f) {
    if slot != RNA_NONE {
        rna_values[slot] = vec4f(dot(n, m), rna_log_gap(n, m), dot(n, wi), dot(n, wo));
        rna_values[slot + 1u] = vec4f(dot(wi, m), 0.0, 0.0, 0.0);
    }
}

fn rna_highlight(slot: u32, n: vec3f, m: vec3f) {
    let aside = cross(n, m);
    let square = select(dot(aside, aside), 1.0, all(m == vec3f(0.0)));
    rna_put(slot, vec4f(log2(square + 1e-8) / 12.0, 0.0, 0.0, 0.0));
}

fn rna_learned_normal(slot: u32, n: vec3f, features: vec3f, m: vec3f) {
    if slot == RNA_NONE {
        return;
    }
    var q = n + 0.1 * features;
    let size = length(q);
    if size < 1e-6 {
        q = n;
    } else {
        q = q / size;
    }
    rna_values[slot] = vec4f(dot(q, m), rna_log_gap(q, m), 0.0, 0.0);
}

// m: of rna_halfway; of lobes n.
fn rna_surface_blocks(n: vec3f, features: vec3f, wo: vec3f, wi: vec3f, m: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_NORMAL), vec4f(n, 0.0));
    rna_half_vector(rna_slot(RNA_BLOCK_HALF_VECTOR), n, m, wo, wi);
    rna_highlight(rna_slot(RNA_BLOCK_HIGHLIGHT), n, m);
    rna_learned_normal(rna_slot(RNA_BLOCK_LEARNED_NORMAL), n, features, m);
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
    let t = (u * a.z + v * b.z + w * c.z) * shear.z / sum;
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
`};var _t=`// A band of the picture between the kernels, and the viewer's own numbers of a step, with rna_gpu's Frame.

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
    form: u32,     // of the answers: FORM_TRANSPORT, two vec4f each; FORM_EMISSION or FORM_ENVIRONMENT, one
    shift: vec2f,  // of the rays, pixels
    pixels: u32,   // of the whole picture
    shares: f32,   // rays a pixel of the first look's edges
}

const FORM_TRANSPORT = 0u;
const FORM_EMISSION = 1u;
const FORM_ENVIRONMENT = 2u;

// A pixel: the members of a row of rna_evaluate, with two numbers in free ones; and its weights.
struct Pixel {
    position: vec4<u32>, // and h of a fiber
    axis: vec4<u32>,     // and part + 1, or 0 where nothing is hit
    wo: vec4<u32>,       // and the primitive
    wi: vec4<u32>,
    through: vec3f, // throughput
    b1: f32,        // barycentric coordinates; of a segment how far along it, 0 to 1
    radiance: vec3f, // over the density, times the throughput; of the ground what it sends on
    b2: f32,
    visibility: vec3f,
    coverage: f32, // of the ground
}

@group(1) @binding(0) var<storage, read_write> band: array<Pixel>;
@group(1) @binding(1) var<uniform> view: View;
`;var qo=`// What decoders of lobes are told of the asset's own visibility about a query's point.

@group(2) @binding(0) var<storage, read> count: array<u32>; // [0]; then the pixel of each row
@group(2) @binding(1) var<storage, read> primitives: array<RnaPrimitive>;
@group(2) @binding(2) var<storage, read> harmonics: array<vec4<u32>>; // of a point, 16 int8: of 127
@group(2) @binding(3) var<storage, read_write> columns: array<vec4f>; // 4 a row

fn harmonic(point: u32, k: u32) -> vec4f {
    return unpack4x8snorm(harmonics[point][k]);
}

@compute @workgroup_size(64)
fn tell_visibility(
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
`;var jo=`// A ray from the camera through each pixel of the band, to the query of its first hit.

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

// There are no lights with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    return found;
}

fn along_segment(record: RnaPrimitive, x: vec3f) -> f32 {
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    return clamp(dot(x - cone.a, way) / max(dot(way, way), 1e-30), 0.0, 1.0);
}

fn pixel_of(hit: RnaHit, wo: vec3f) -> Pixel {
    var pixel: Pixel;
    pixel.wo = words(wo, hit.primitive);
    if hit.instance == RNA_NOTHING {
        return pixel;
    }
    let record = rna_primitives[hit.primitive];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, hit.b1, hit.b2);
    } else {
        var path: Path;
        path.origin = frame.camera;
        path.direction = -wo;
        path.t = hit.t;
        path.normal = hit.normal;
        v = segment_vertex(path, record, wo);
    }
    pixel.position = words(v.x, bitcast<u32>(v.h));
    pixel.axis = words(v.axis, surface_part(rna_surface(record)) + 1u);
    pixel.b1 = select(hit.b1, along_segment(record, v.x), rna_is_segment(record));
    pixel.b2 = hit.b2;
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
    let found = closest_through(ray, RNA_NOTHING, chance_of(number));
    var pixel = pixel_of(found.hit, -d);
    pixel.through = found.weight;
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
        band[k].axis = pixel_of(hit, bitcast<vec3f>(band[k].wo.xyz)).axis;
    }
}
`;var Zo=`// For each query a direction of one light, the radiance from there, and how much of it the asset lets through; and
// the light on the ground. sources.js declares the kinds of light.

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
    n: vec3f, // turned to the viewer
    mirror: vec3f,
}

const MIRRORED = 1.0 / 3.0;
const FROM_ALL_SIDES = 0.25;

fn mirrored_share(at: Surroundings) -> f32 {
    return select(MIRRORED, 0.0, all(at.mirror == vec3f(0.0)));
}

fn direction_about(at: Surroundings, u: vec2f) -> vec3f {
    let share = mirrored_share(at);
    if u.y < share {
        return normalize(along_axis(at.mirror, fisher_cosine(u.y / share, MIRROR_KAPPA), u.x));
    }
    let rest = (u.y - share) / (1.0 - share);
    let all_sides = rest < FROM_ALL_SIDES;
    let v = select((rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES), rest / FROM_ALL_SIDES, all_sides);
    let ball = along_axis(vec3f(0.0, 0.0, 1.0), 1.0 - 2.0 * v, u.x);
    return normalize(ball + select(at.n * 1.0001, vec3f(0.0), all_sides));
}

fn density_about(at: Surroundings, wi: vec3f) -> f32 {
    if all(at.n == vec3f(0.0)) {
        return SPHERE_PDF;
    }
    let rest = mix(max(0.0, dot(at.n, wi)) / PI, SPHERE_PDF, FROM_ALL_SIDES);
    return mix(rest, fisher_pdf(dot(at.mirror, wi), MIRROR_KAPPA), mirrored_share(at));
}

fn surroundings_of(pixel: Pixel) -> Surroundings {
    if pixel.axis.w == 0u {
        return Surroundings(vec3f(0.0, 1.0, 0.0), vec3f(0.0)); // of the ground
    }
    if rna_is_segment(rna_primitives[pixel.wo.w]) {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// The direction that lobes are asked with. To the ground one by the cosine, with the irradiance in the view's colour.
fn mirrored(number: u32, pixel: Pixel) -> Arrival {
    if pixel.axis.w == 0u {
        let u = at_point(number, DIRECTION);
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
    let at = surroundings_of(pixel);
    if view.kind == LIGHT_MIRROR {
        return mirrored(number, pixel);
    }
    if view.kind == LIGHT_ENVIRONMENT {
        let bright = sample_image(0u, at_point(number, LIGHT));
        return Arrival(bright.wi, bright.radiance / (bright.pdf + density_about(at, bright.wi)));
    }
    let wi = direction_about(at, at_point(number, DIRECTION));
    let sky = look_up_image(0u, wi);
    return Arrival(wi, sky.radiance / (sky.pdf + density_about(at, wi)));
}

// How much of the light along wi the asset itself lets through to a point of it.
fn visibility_of(pixel: Pixel, wi: vec3f) -> vec3f {
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
    return start_visibility(0u, RnaRay(leaving_point(v, wi), 0.0, wi, RNA_FAR), v.strand);
}

// The ground, seen along d, shows the shadow and fades with the distance: what it sends on of light along wi; and how
// much it covers.
fn ground_seen(d: vec3f, wi: vec3f) -> vec4f {
    if view.ground_size == 0.0 || d.y * (frame.camera.y - view.ground) >= 0.0 {
        return vec4f(0.0);
    }
    let x = frame.camera + d * ((view.ground - frame.camera.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - view.middle) / view.ground_size);
    let weight = fade * max(0.0, wi.y) * view.ground_colour;
    if all(weight <= vec3f(0.0)) {
        return vec4f(0.0, 0.0, 0.0, fade);
    }
    let step = 0x1p-18f * rna_instances[0].extent;
    let way = RnaRay(x + vec3f(0.0, step, 0.0), 0.0, wi, RNA_FAR);
    return vec4f(weight * start_visibility(0u, way, RNA_NOTHING), fade);
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
    let arrival = arrival_at(view.first + k, pixel);
    pixel.wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), 0u);
    pixel.radiance = pixel.through * arrival.radiance;
    if pixel.axis.w != 0u {
        pixel.visibility = visibility_of(pixel, arrival.wi);
    } else {
        let ground = ground_seen(-bitcast<vec3f>(pixel.wo.xyz), arrival.wi);
        pixel.radiance *= ground.xyz;
        pixel.coverage = ground.w;
    }
    band[k] = pixel;
}
`;var Yo=`// The first look without jagged edges: more rays a pixel, each with the light of the pixels nearby that saw what it sees.

@group(2) @binding(0) var<storage, read_write> seen: array<vec4<u32>>; // from pixels' middles: distance, axis, part + 1
@group(2) @binding(1) var<storage, read_write> look: array<vec4f>;

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

// How unlike what the pixel at \`place\` saw from its middle is to a hit of the same part.
fn difference(hit: Pixel, other: vec4<u32>, place: vec2f) -> f32 {
    if hit.axis.w == 0u {
        return 0.0;
    }
    let n = bitcast<vec3f>(hit.axis.xyz);
    let raw = raw_direction(place);
    let away = bitcast<f32>(other.x);
    let x = frame.camera + away * normalize(raw);
    let size = away * length(frame.step_x) / length(raw); // of a pixel there
    let off = abs(dot(n, x - bitcast<vec3f>(hit.position.xyz))) / max(size, 1e-30);
    return 1.0 - dot(n, vec3f(unpack2x16snorm(other.y), unpack2x16snorm(other.z).x)) + off;
}

// The light of the neighbours that are like the band's hit, whose ray went beside the middle by the view's shift.
fn light_beside(number: u32, hit: Pixel) -> vec4f {
    let middle = vec2<i32>(vec2<u32>(number % frame.width, number / frame.width));
    let narrow = select(APART, APART_ON_GROUND, hit.axis.w == 0u);
    var sum = vec4f(0.0);
    var total = 0.0;
    for (var j = 0; j < 9; j++) {
        let step = vec2<i32>(j % 3 - 1, j / 3 - 1);
        let at = middle + step;
        let there = u32(at.y) * frame.width + u32(at.x);
        if at.x < 0 || at.y < 0 || at.x >= i32(frame.width) || there >= view.pixels || seen[there].w != hit.axis.w {
            continue;
        }
        let apart = vec2f(step) - view.shift;
        let unlike = min(difference(hit, seen[there], vec2f(at) + 0.5), 4.0);
        let weight = exp(-UNLIKE * unlike - narrow * dot(apart, apart));
        sum += weight * sums[there];
        total += weight;
    }
    if total == 0.0 {
        return select(sums[number], vec4f(0.0), hit.axis.w == 0u); // nobody saw such a thing
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
`;var Es=`// The light of the whole environment that a part sends to the viewer, of each row: its lobes, by one look-up each in the
// prefiltered environment.

struct LobeLight {
    colour: vec3f, // of a texel of 1
    levels: f32,
    turn: vec2f,   // cosine and sine, as render/environment.wgsl turns an image
    least_kappa: f32, // of the first level
    an_octave: f32,   // levels
}

@group(1) @binding(0) var<storage, read> rows: array<RnaRow>; // wi: the mirror direction; then its visibility
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
    var sum = vec3f(0.0);
    for (var j = 0u; j < RNA_LOBES; j++) {
        let lobe = rna_lobe(place, j, axis, wo, m, bitcast<f32>(at.reserved_3));
        sum += lobe.amplitude * mean_under(lobe);
    }
    answers[row] = vec4f(light.colour * sum, 0.0);
}
`;var Rs=`// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

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

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part {
        return;
    }
    let pixel = band[k];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], k);
    // No block of emission reads wi.
    let wi = select(pixel.wi, pixel.wo, view.form == FORM_EMISSION);
    let free = dot(pixel.visibility, vec3f(1.0 / 3.0)); // read with lobes alone
    rows[at] = RnaRow(pixel.position.xyz, pixel.position.w, pixel.axis.xyz, 0u, pixel.wo.xyz, 0u, wi.xyz, bitcast<u32>(free));
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
    if view.form == FORM_TRANSPORT {
        radiance = pixel.radiance * mix(answers[2u * at + 1u].xyz, answers[2u * at].xyz, pixel.visibility);
    }
    sums[view.first + k] += vec4f(radiance, 0.0);
}
`;var ks=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB, alpha
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
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;
@group(0) @binding(2) var<storage, read> first_look: array<vec4f>; // the first look

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

// Values of the screen, sRGB, premultiplied, of a mean.
fn displayed(mean: vec4f) -> vec4f {
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
    let here = displayed(mean);
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
            let value = displayed(other);
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
`;var Wo=`// What segment.wgsl has, for assets without strands: code that an asset has no use for is not compiled, which takes
// most of the time to its first picture.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

struct RnaEntry {
    t: f32,
    normal: vec3f,
}

fn rna_cone(point: u32) -> RnaCone {
    return RnaCone(vec3f(0.0), 0.0, vec3f(0.0), 0.0);
}

fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    return RNA_FAR;
}

fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    return RnaEntry(RNA_FAR, vec3f(0.0));
}
`;var Vo=`// What normal_maps.wgsl and render/transmittance.wgsl have, for assets without textures.

fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    return n;
}

fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    return vec3f(0.0);
}
`;for(let r of[_t,Es,Rs,ks])ni(r);var Ko=r=>r in ct?[r]:gt[r].flatMap(Ko),Zt=(r,e=ct)=>[...new Set(r.flatMap(Ko))].map(t=>e[t]).join(`
`);function cr(r,...e){return Object.entries(r).map(([n,s])=>`const ${n}: u32 = ${s}u;
`).join("")+Zt(e)}function lr({hasSegments:r,hasTextures:e}){let t={...ct};return r||(t["segment.wgsl"]=Wo),e||Object.assign(t,{"normal_maps.wgsl":Vo,"render/transmittance.wgsl":""}),{hit:Zt(gt.hit,t)+_t+jo,light:[Zt(gt.light,t),_t,ri,Zo].join(`
`)}}var vt={columns:Zt(gt.columns)+_t+qo,lobes:`${ct["environment_lobes.wgsl"]}
${ct["row_records.wgsl"]}
${Es}`,look:Zt(gt.queue)+_t+Yo,queue:Zt(gt.queue)+_t+Rs,show:ks};var ur=class{constructor(e){this.device=e,this.made=new Map}get(e,t,n){let s=`${t}
${e}`;return this.made.has(s)||this.made.set(s,this._make(e,t,n)),this.made.get(s)}async _make(e,t,n){let s=await sr(this.device,e),i=n?this.device.createPipelineLayout({bindGroupLayouts:n}):"auto";return this.device.createComputePipelineAsync({layout:i,compute:{module:s,entryPoint:t}})}},Yt=class{static make(e,t,n,s,i,o){let l={constants:{RNA_COLOURS:s.outputs===6?2:1},parts:[n.kind,"evaluate"],kernel:"",entryPoint:"rna_evaluate"};return this.of(e,t,ar(n,s,i),o,l)}static async of(e,t,{weights:n,record:s,groups:i},o,{constants:c,parts:l,kernel:f,entryPoint:p}){let d=new this,{UNIFORM_WEIGHTS:_}=ce,w=n.length/4<=_,A=w?"weights_uniform.wgsl":"weights_storage.wgsl";d.pipeline=await t.get(cr({RNA_GROUPS:i,...c},A,...l)+f,p);let{UNIFORM:R,STORAGE:L}=GPUBufferUsage,H=w?new Float32Array(4*_):n;return w&&H.set(n),d.buffers=[ne(e,s,R,"a decoder"),ne(e,H,w?R:L,"a decoder")],d.part=gn(e,d.pipeline,0,[...d.buffers,...o]),d.device=e,d}run(e,{rows:t,answers:n,count:s},i){this.dispatch(e,[t,n,s],i)}dispatch(e,t,n,s=[]){this.bound??=gn(this.device,this.pipeline,1,t),fe(e,this.pipeline,[this.part,this.bound,...s],n)}delete(){for(let e of this.buffers)e.destroy()}};function*Xo(r,[e,t]){let n=e+1,s=r.reduce((c,l)=>c+l,0)/r.length||1,i=yield*Ku(r,e,t,s),o=new Uint16Array(4*t*n*19);for(let c=0;c<19;c++){let l=.25*2**(c/2);for(let f=0;f<n;f++){let p=Xu(i,Math.PI*f/e,e,t/2,l);Qu(o,4*t*(c*n+f),p,t),yield}}return{texels:o,width:t,height:n,levels:19,unit:s}}var Jo=r=>Float64Array.from({length:r},(e,t)=>Math.cos(2*Math.PI*t/r)),Qo=(r,e)=>2*Math.PI*(Math.cos(Math.PI*r/e)-Math.cos(Math.PI*(r+1)/e));function*Ku(r,e,t,n){let s=t/2,i=new Float64Array(6*e*s),o=Jo(t);for(let c=0;c<e;c++){yield;let l=Qo(c,e)/t;for(let f=0;f<s;f++)for(let p=0;p<t;p++){let d=f*p,_=6*(c*s+f),w=3*(c*t+p),A=l/n*o[d%t],R=l/n*o[(d+.75*t)%t];for(let L=0;L<3;L++)i[_+L]+=r[w+L]*A,i[_+3+L]+=r[w+L]*R}}return i}function Xu(r,e,t,n,s){let i=new Float64Array(6*n),o=new Float64Array(n),c=0;for(let l=0;l<t;l++){let f=Math.PI*(l+.5)/t,p=Math.exp(s*(Math.cos(e-f)-1));if(!(p<1e-6)){Ju(s*Math.sin(e)*Math.sin(f),o),c+=p*o[0]*Qo(l,t);for(let d=0;d<n&&o[d]>1e-6;d++){let _=p*o[d]*(d?2:1),w=6*(n*l+d),A=6*d;for(let R=0;R<6;R++)i[A+R]+=_*r[w+R]}}}return i.map(l=>l/c)}function Ju(r,e){let t=Math.min(e.length-1,Math.ceil(8+6*Math.sqrt(r))),n=0;for(let o=t+8;o>0;o--)n=r/(2*o+r*n),o<=t&&(e[o]=n);let s=1,i=1;for(let o=1;o<=t;o++)s*=e[o],e[o]=s,i+=2*s;e[0]=1;for(let o=0;o<=t;o++)e[o]/=i;e.fill(0,t+1)}function Qu(r,e,t,n){let s=Jo(n),i=n/2;for(;i>1&&t.subarray(6*i-6,6*i).every(o=>Math.abs(o)<1e-6);)i-=1;for(let o=0;o<n;o++){let c=0,l=0,f=0;for(let p=0,d=0,_=0;p<i;p++,d=(d+o)%n,_+=6){let w=s[d],A=s[(d+.75*n)%n];c+=t[_]*w+t[_+3]*A,l+=t[_+1]*w+t[_+4]*A,f+=t[_+2]*w+t[_+5]*A}[c,l,f].forEach((p,d)=>{r[e+4*o+d]=tf(p)})}}var ea=new Float32Array(1),ef=new Uint32Array(ea.buffer);function tf(r){return ea[0]=Math.max(r,0),Math.max(0,Math.min(31743,(ef[0]+4096>>>13)-114688))}var[ta,na,Ss]=["uniform","storage","read-only-storage"],fr=class r{static async make(e,t,n){let s=new r,{device:i,pipelines:o,bandPixels:c}=e;Object.assign(s,{device:i,engine:e,rest:null});let l=new Int8Array(4*t.points.length);return n.forEach(({environment:f},p)=>l.set(f.harmonics??[],16*t.parts[p].point)),s.harmonics=ne(i,l,void 0,"the asset's visibility"),s.columns=ne(i,4*Ht*c),s.record=ne(i,Ke("LobeLight"),GPUBufferUsage.UNIFORM),s.layouts=[Ie(i,{0:ta}),Ie(i,{0:na,1:ta}),Ie(i,{0:Ss,1:Ss,2:Ss,3:na})],s.tell=await o.get(vt.columns,"tell_visibility",s.layouts),s.sampler=i.createSampler({addressModeU:"repeat",magFilter:"linear",minFilter:"linear"}),s}set({rest:e,turn:t,radiance:n}){let{device:s}=this,{texels:i,width:o,height:c,levels:l,unit:f}=e;this.rest!==e&&(this.texture?.destroy(),this.texture=s.createTexture({size:[o,c,l],format:"rgba16float",usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST}),s.queue.writeTexture({texture:this.texture},i,{bytesPerRow:8*o,rowsPerImage:c},[o,c,l]),this.rest=e),s.queue.writeBuffer(this.record,0,ae("LobeLight",{colour:n.map(p=>p*f),levels:l,turn:[Math.cos(t),Math.sin(t)],least_kappa:.25,an_octave:2}))}run(e,{count:t},n){let{engine:{frameRecord:s,band:i,viewRecord:o,geometry:c},device:l,layouts:f}=this;this.groups??=[[s],[i,o],[t,c[1],this.harmonics,this.columns]].map((p,d)=>Fe(l,f[d],p)),fe(e,this.tell,this.groups,n)}delete(){for(let e of[this.harmonics,this.columns,this.record,this.texture])e?.destroy()}},hr=class extends Yt{static async make(e,t,n,s,i){let{environment:o}=n,c=o.harmonics?Ht:0,l=await super.of(e,t,ar({...n,planes:o.planes},o,o.inputs,c),s,{constants:{RNA_LOBES:o.lobes,RNA_IS_FIBER:+(n.kind==="fiber"),RNA_VISIBILITY_GROUPS:c/4},parts:[n.kind],kernel:vt.lobes,entryPoint:"light_by_lobes"});return Object.assign(l,{shared:i})}run(e,t,n){let{shared:s,device:i,pipeline:o}=this;if(s.run(e,t,n),this.texture!==s.texture){this.texture=s.texture;let c=[{buffer:s.record},s.texture.createView({dimension:"2d-array"}),s.sampler];this.lit=i.createBindGroup({layout:o.getBindGroupLayout(2),entries:c.map((l,f)=>({binding:f,resource:l}))})}this.dispatch(e,[t.rows,t.answers,t.count,s.columns],n,[this.lit])}};var vn=1<<17,sf=["transport","emission","environment"],pr=class r{static async open(e){let t=new r,n=await Mo();Object.assign(t,{canvas:e,device:n,parts:[],lost:!1,bandPixels:vn}),n.lost.then(({reason:i,message:o})=>{t.lost=!0,t.closed||t.onlost?.(`the GPU was lost (${o||i})`)}),n.addEventListener("uncapturederror",({error:i})=>{t.error??=i}),t.context=e.getContext("webgpu");let s=navigator.gpu.getPreferredCanvasFormat();return t.context.configure({device:n,format:s,alphaMode:"premultiplied",usage:GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.COPY_SRC}),t.pipelines=new ur(n),t.compiled=t._compile(s),t.compiled.catch(()=>{}),t}async _compile(e){let{device:t}=this,n=await sr(t,vt.show),[s,i,o]=["uniform","storage","read-only-storage"],c=Ie(t,{0:i,1:s});this.rayLayout=[Ie(t,{0:s,4:o,5:o}),c,Ie(t,{0:o,1:o,2:o,3:o,4:o})],this.queueLayout=[Ie(t,{0:s,2:i}),c,Ie(t,{0:i,1:i,2:i})],this.lookLayout=[...this.queueLayout.slice(0,2),Ie(t,{0:i,1:i})];let[l,f,p,d,_,w]=await Promise.all([...["begin","gather","scatter"].map(A=>this.pipelines.get(vt.queue,A,this.queueLayout)),...["remember","smooth_edges"].map(A=>this.pipelines.get(vt.look,A,this.lookLayout)),t.createRenderPipelineAsync({layout:"auto",vertex:{module:n,entryPoint:"corner"},fragment:{module:n,entryPoint:"colour",targets:[{format:e}]}})]);Object.assign(this,{queueKernels:{begin:l,gather:f,scatter:p,remember:d,smooth:_},shown:w}),this._makeBand()}_makeBand(){let{device:e}=this,{UNIFORM:t}=GPUBufferUsage;this.frameRecord=ne(e,ae("Frame",{}),t),this.viewRecord=ne(e,Ke("View"),t),this.showRecord=ne(e,Ke("Show"),t),this.band=ne(e,Ke("Pixel")*vn),this.queue={rows:ne(e,Ke("RnaRow")*vn),answers:ne(e,32*vn),count:ne(e,4*(vn+4))},this._bind()}async setAsset(e,t){let{device:n,pipelines:s}=this;this._deleteAsset();let i=(_,w)=>ne(n,_,void 0,`the asset's ${w}`);this.geometry=[i(e.nodes,"hierarchy"),i(e.primitives,"geometry"),i(e.points,"geometry"),i(of(e.extent),"geometry"),i(e.normals,"geometry")],this.lightsAt=e.table.length/4,this.table=ne(n,4*e.table.length+Ke("Light")),n.queue.writeBuffer(this.table,0,e.table),this.arrays=e,this._storeImages(),await this.compiled,this.raySources=lr({hasSegments:e.strands>0,hasTextures:e.hasTextures});let{hit:o,light:c}=this.raySources,l=t.every(({environment:_})=>_);this.lobeLight=l?await fr.make(this,e,t):null;let[f,p,...d]=await Promise.all([s.get(o,"trace_pixels",this.rayLayout),s.get(c,"light_pixels",this.rayLayout),...t.map(_=>this._makePart(_))]);Object.assign(this,{parts:d,hasLobes:l}),this.kernels={hit:f,light:p,...this.queueKernels},this._makeSums()}async _makePart(e){let{device:t,pipelines:n}=this,s=_=>[0,1,2].map(w=>ne(t,Go(_,w),void 0,"a plane of features")),i=s(e.planes),{environment:o}=e,c=this.lobeLight&&o.planes!==e.planes?s(o.planes):null,l=(_,w)=>Yt.make(t,n,e,_,w,i),[f,p,d]=await Promise.all([l(e.transport,e.inputs),e.emission&&l(e.emission,e.emission.inputs),this.lobeLight&&hr.make(t,n,e,c??i,this.lobeLight)]);return{planes:[...i,...c??[]],transport:f,emission:p,environment:d}}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment(e){this.environment=e,this._storeImages(),this._bind()}_storeImages(){if(!this.geometry)return;let{images:e}=this.arrays,t=this.environment?.floats??new Float32Array(0);this.images?.destroy(),this.images=ne(this.device,4*(e.length+t.length),void 0,"the environment"),this.device.queue.writeBuffer(this.images,0,e),this.device.queue.writeBuffer(this.images,4*e.length,t)}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let n=e*t;this.target={width:e,height:t},!(this.sums&&n<=this.capacity&&n*8>=this.capacity)&&(this.capacity=n,this._makeSums())}_makeSums(){if(!this.capacity)return;for(let n of[this.sums,this.firstLook,this.seen])n?.destroy();let e=n=>ne(this.device,16*n,void 0,"the picture"),t=this.hasLobes?this.capacity:1;Object.assign(this,{sums:e(this.capacity),firstLook:e(t),seen:e(t)}),this._bind()}_bind(){if(!this.geometry||!this.sums||!this.band||!this.kernels)return;let{device:e,rayLayout:t,queueLayout:n,queue:s}=this,i=Fe(e,t[1],{0:this.band,1:this.viewRecord}),o=Fe(e,n[2],[s.rows,s.answers,s.count]),c=Fe(e,n[0],{0:this.frameRecord,2:this.sums});this.groups={rays:[Fe(e,t[0],{0:this.frameRecord,4:this.table,5:this.images}),i,Fe(e,t[2],this.geometry)],queue:[c,i,o],look:[c,i,Fe(e,this.lookLayout[2],[this.seen,this.firstLook])],show:gn(e,this.shown,0,[this.showRecord,this.sums,this.firstLook])}}trace(e,t,n,s){let{width:i}=this.target;this.span={first:n*i,pixels:(s-n)*i,jitter:e.jitter??1,shift:e.shift??[0,0]},this._writeFrame(e,t),this._writeView({}),this._run(o=>fe(o,this.kernels.hit,this.groups.rays,this.span.pixels))}light(e,{isFirst:t,countsCoverage:n}){this._writeLight(e),this.view={...e,isFirst:t,countsCoverage:n},this._writeView(this.view),this._run(s=>{fe(s,this.kernels.light,this.groups.rays,this.span.pixels),fe(s,this.kernels.begin,this.groups.queue,this.span.pixels)}),e.kind==="mirror"&&this.lobeLight.set(e),this._decode(e.kind==="mirror"?"environment":"transport")}emission(){this._decode("emission")}remember(){this._run(e=>fe(e,this.kernels.remember,this.groups.look,this.span.pixels))}smoothEdges(e,t){this._writeView({shares:e,isFirst:t}),this._run(n=>fe(n,this.kernels.smooth,this.groups.look,this.span.pixels))}show({rounds:e,firstLook:t,rowsAhead:n,exposure:s,backdrop:i,filmic:o,spread:c}){let{width:l,height:f}=this.target,{canvas:p,device:d}=this;d.queue.writeBuffer(this.showRecord,0,ae("Show",{size:[p.width,p.height],picture:[l,f],backdrop:i,rounds:e,rows_ahead:n,exposure:s,filmic:Number(o),spread:c,first_look:t}));let _=d.createCommandEncoder(),w=this.context.getCurrentTexture().createView(),A=_.beginRenderPass({colorAttachments:[{view:w,loadOp:"clear",storeOp:"store"}]});A.setPipeline(this.shown),A.setBindGroup(0,this.groups.show),A.draw(3),A.end(),d.queue.submit([_.finish()])}async done(){if(await this.device.queue.onSubmittedWorkDone(),this.error)throw this.error}async picture(){let{width:e,height:t}=this.target;return new Float32Array(await _n(this.device,this.sums,16*e*t))}_decode(e){for(let[t,n]of this.parts.entries()){let s=n[e];s&&(this._writeView({...this.view,part:t+1,form:sf.indexOf(e)}),this.device.queue.writeBuffer(this.queue.count,0,Uint32Array.of(0)),this._run(i=>{fe(i,this.kernels.gather,this.groups.queue,this.span.pixels),s.run(i,this.queue,this.span.pixels),fe(i,this.kernels.scatter,this.groups.queue,this.span.pixels)}))}}_run(e){let t=this.device.createCommandEncoder(),n=t.beginComputePass();e(n),n.end(),this.device.queue.submit([t.finish()])}_writeFrame({position:e,corner:t,stepX:n,stepY:s},i){let{lightsAt:o,arrays:c,span:l,target:f}=this;this.device.queue.writeBuffer(this.frameRecord,0,ae("Frame",{camera:e,corner:t,step_x:n,step_y:s,width:f.width,paths:l.pixels,sample:i,branches:1,depth:1,rays:ce.CAMERA_RAY,flags:c.transmits?ce.TRANSMITS:0,textures:c.texturesAt,lights:o}))}_writeView({kind:e="sun",direction:t=[0,0,0],colour:n=[0,0,0],ground:s,isFirst:i=!1,countsCoverage:o=!1,part:c=0,form:l=0,shares:f=1}){let{first:p,jitter:d,shift:_=[0,0]}=this.span,{width:w,height:A}=this.target,R=s&&{ground:s.height,ground_colour:s.colour,ground_size:s.size,middle:[s.x,s.z]};this.device.queue.writeBuffer(this.viewRecord,0,ae("View",{first:p,jitter:d,kind:Or[e],is_first:Number(i),direction:t,counts_coverage:Number(o),colour:n,part:c,form:l,shift:_,pixels:w*A,shares:f,...R}))}_writeLight({angle:e,colour:t}){if(e===void 0)return;let{width:n,height:s,total:i,places:o}=this.environment,c={turn_cosine:Math.cos(e),turn_sine:Math.sin(e)},l=si("image",{colour:t,...c,total:i,rows:s,columns:n});this.device.queue.writeBuffer(this.table,16*this.lightsAt,ae("Light",{kind:ce.IMAGE,group:ce.NONE,numbers:l,places:o.map(f=>f+this.arrays.images.length)}))}_deleteAsset(){for(let e of[...this.geometry??[],this.table,this.images])e?.destroy();this.lobeLight?.delete();for(let{planes:e,...t}of this.parts){e.forEach(n=>n.destroy());for(let n of Object.values(t))n?.delete()}this.parts=[],this.geometry=this.images=null}close(){this.closed=!0,this._deleteAsset(),this.device.destroy()}},of=r=>ae("RnaInstance",{to_object:[1,0,0,0,0,1,0,0,0,0,1,0],rotation:[1,0,0,0,0,1,0,0,0,0,1,0],scale:1,root:1,rays:ce.CAMERA_RAY,extent:r});function ra(r,e){let{cameraControls:t,disableZoom:n,wheelZoom:s}=r.settings;if(!t||e.type!=="wheel")return t;let i=r.place.getRootNode().activeElement===r.canvas;return!n&&(s==="always"||i||e.ctrlKey||e.metaKey)}function sa(r){let e=(t,n)=>(...s)=>{r.settings[n]||(t(...s),r.isTouched=!0,r.viewer.restart(s.at(-1)===!0),r.tell("camera",{byUser:!0}))};return{orbit:e((t,n)=>r.orbit.turn(t,n)),pan:e((t,n)=>r.orbit.pan(t,n),"disablePan"),zoom:e(t=>r.orbit.zoom(t),"disableZoom"),light:(t,n,s)=>{if(r.settings.disableLight)return;let i=zn(r.lighting.rotation+t*180/Math.PI),o=js(r.lighting.sunHeight+n*180/Math.PI,-10,90);r.setLight({rotation:i,sunHeight:o},{moving:s===!0,byUser:!0})},settle:()=>r.viewer.moving&&r.viewer.restart(),reset:()=>r.reset()}}var ia=[[1,3],[-3,1],[3,-1],[-1,-3]].map(r=>r.map(e=>e/8)),af={kind:"sun",direction:[0,1,0],colour:[0,0,0]},dr=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{engine:e,canvas:t,orbit:n}),Object.assign(this,{lights:[],firstLights:null,ground:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,generation:0,msPerPixel:.005,shown:null,rowsAhead:0,ready:!1,stopped:!1,moving:!1,resting:!1,backdrop:null,stats:{ms:0,rounds:0}}),this.wake=null}restart(e=!1){this.moving=e,Object.assign(this.stats,{rounds:0,scale:0}),this.generation+=1,this.wake?.()}start(){this.ready=!0,this.running??=this._run(),this.restart()}pause(){this.ready=!1,this.generation+=1}rest(e){this.resting=e,e||this.rouse?.()}stop(){return this.stopped=!0,this.rest(!1),this.pause(),this.wake?.(),this.running}async pictured(){for(;!this.shown;)await this._nextPicture()}async converged(e=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=e);)await this._nextPicture()}_nextPicture(){return new Promise(e=>this.addEventListener("shown",e,{once:!0}))}show(){if(!this.shown)return;let{rounds:e,firstLook:t}=this.shown,n=this.denoise&&e<12&&!t;this.engine.show({rounds:e,firstLook:t,rowsAhead:this.rowsAhead,exposure:2**this.exposure,backdrop:this.backdrop?[...this.backdrop,1]:[0,0,0,0],filmic:this.view==="filmic",spread:n?.4/Math.sqrt(e):0})}async _run(){for(;!this.stopped;){let e=this.generation;try{this.ready&&await this._picture(e)}catch(t){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:t})),this.ready=!1}e===this.generation&&!this.stopped&&await new Promise(t=>{this.wake=t})}}async _picture(e){for(let t of this._scales()){let n=t===1&&!this.moving?this.rounds:+!this.firstLights;if(!await this._stage(e,t,n)||this.moving)return}}_scales(){let e=this.canvas.width*this.canvas.height*Math.max(1,(this.firstLights??this.lights).length),t=1;for(;t<16&&e*this.msPerPixel/t**2>110;)t*=2;let n=[t];for(;t>1;)n.push(t=t>4?t/4:1);return n}async _stage(e,t,n){let{engine:s,canvas:i}=this,o=Math.ceil(i.width/t),c=Math.ceil(i.height/t);this.shown=null,s.resize(o,c);let l={...this.orbit.camera(o,c),jitter:this.jitter},{firstLights:f}=this;if(f){let p=performance.now();if(!await this._look(e,{...l,jitter:0}))return!1;this._present(0,t,1),this._measure(performance.now()-p,o*c,f.length)}else if(!this.hasShown){if(!await this._round(e,l,0,this.lights.slice(0,1)))return!1;this._present(1,t,0)}for(let p=0;p<n;p++){let d=performance.now();if(!await this._round(e,l,p,this.lights))return!1;let _=performance.now()-d;this._present(p+1,t,f?cf(p+1):0),this._measure(_,o*c,this.lights.length),t===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*_:_)}return!0}_round(e,t,n,s){return this._bands(e,s.length,(i,o)=>{this._band(t,n,s,i,o),this.shown?.rounds===n&&(this.rowsAhead=o)})}async _look(e,t){let{engine:n,firstLights:s}=this;return await this._bands(e,s.length,(o,c)=>{this._band(t,0,s,o,c),n.remember()})?this._bands(e,1,(o,c)=>ia.forEach((l,f)=>{n.trace({...t,shift:l},0,o,c),n.smoothEdges(ia.length,f===0)})):!1}async _bands(e,t,n){let{engine:s}=this,{width:i,height:o}=s.target,c=this.msPerPixel*i*Math.max(1,t),l=Math.max(1,Math.min(o,Math.floor(120/c),Math.floor(s.bandPixels/i)));for(let f=0;f<o;f+=l)if(this.resting&&await new Promise(p=>{this.rouse=p}),n(f,Math.min(o,f+l)),await s.done(),e!==this.generation||this.stopped||s.lost)return!1;return!0}_band(e,t,n,s,i){let{engine:o}=this;o.trace(e,t,s,i),(n.length?n:[af]).forEach((l,f)=>o.light({...l,ground:this.ground},{isFirst:t===0&&f===0,countsCoverage:f===0})),o.emits&&o.emission()}_present(e,t,n){Object.assign(this,{shown:{rounds:e,firstLook:n},rowsAhead:0}),this.show(),this.hasShown||performance.mark("picture"),this.hasShown=!0,Object.assign(this.stats,{rounds:e,scale:t}),this.dispatchEvent(new Event("shown"))}_measure(e,t,n){let s=e/(t*Math.max(1,n));this.msPerPixel=t<4096?Math.min(this.msPerPixel*4,s):.5*(this.msPerPixel+s)}},cf=r=>Math.max(0,1-r/64)/(1+r/8);var lf=22e5,uf=4,ff=6e4,mr=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{place:e,notices:t,settings:n,losses:0,lives:0,isResting:!1}),this.look={backdrop:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1},new ResizeObserver(()=>this.resize()).observe(e)}begin(){return this.replace()}end(){this.lives+=1,this.begun=Promise.resolve(!1),this.viewer?.stop(),this.engine?.close(),Object.assign(this,{viewer:null,engine:null})}replace(){this.end(),this.since=performance.now();let e=this._begin().then(()=>e===this.begun?!!this.engine:this.begun,t=>e!==this.begun?this.begun:(this.end(),this.failed(t,"engine"),!1));return this.begun=e}async _begin(){let e=this.lives,t=document.createElement("canvas"),n=await pr.open(t);if(e!==this.lives)return n.close();Object.assign(this,{engine:n,canvas:t}),this.place.replaceChildren(t),n.onlost=s=>this._lost(n,s),this.viewer=Object.assign(new dr(n,t,this.orbit),this.look,{resting:this.isResting}),this.viewer.addEventListener("shown",()=>this.pictured()),this.viewer.addEventListener("failed",({error:s})=>this._lost(n,oa(s))),performance.mark("engine"),zo(t,sa(this),s=>ra(this,s)),this.tell("engine"),this.resize(),await this.restore(n)}rest(e){this.isResting=e,this.viewer?.rest(e)}resize(){if(!this.viewer)return;let{clientWidth:e,clientHeight:t}=this.place,n=this.settings.pixelRatio??Math.min(devicePixelRatio,2),s=Math.min(n,Math.sqrt(lf/Math.max(1,e*t))),i=Math.max(1,Math.round(e*s)),o=Math.max(1,Math.round(t*s));this.canvas.width===i&&this.canvas.height===o||(Object.assign(this.canvas,{width:i,height:o}),this.resized(),this.viewer.restart())}get wgsl(){return{compose:cr,sharedFiles:ct,rayKernels:lr}}reader(){return this.viewer.pause(),new ir(this.engine)}async screenshot(e="image/png",t=void 0){return await this.viewer.pictured(),this.viewer.show(),new Promise(n=>this.canvas.toBlob(n,e,t))}async _lost(e,t){if(e===this.engine){if(this.losses=performance.now()-this.since>ff?1:this.losses+1,this.losses>=uf)return this.end(),this.failed(new G(`${t}, ${this.losses} times`),"engine");this.notices.say(`${t}; starting again`,!0,"engine"),await this.replace()&&this.notices.say(null,!1,"engine")}}tell(e,t){this.dispatchEvent(Object.assign(new Event(e),t))}failed(e,t){aa(e)||console.error(e),this.notices.say(oa(e),!1,t),this.failures=(this.failures??0)+1,this.tell("failed",{error:e,about:t})}},aa=r=>r instanceof Qt||r instanceof G,oa=r=>aa(r)?r.message:`this did not work: ${r.message??r}`;var Ce=[64,128],la=[64,128],hf=512,pf=4,ca=8,df=Math.cos(15*Math.PI/180),mf=200,yt=Ce[0]*Ce[1],ua=r=>jn(gf(r));function*gf(r){let e=_f(r),t=vf(e);yield;let{flux:n,sums:s,directions:i}=yf(e.rgb,t);yield;let{excess:o,share:c}=wf(n),l=xf(o),f=new Uint8Array(yt);for(let _ of l)for(let w of _)f[w]=1;yield;let{radiance:p,up:d}=Rf(e.rgb,t,_=>f[_]?1-c[_]:1);return{lights:l.map(_=>Ef(_,o,w=>s[w]*c[Math.floor(w/3)],i)),up:d,rest:yield*Xo(p,la)}}function _f({rgb:r,width:e,height:t}){let n=Math.ceil(hf/e);if(n<=1)return{rgb:r,width:e,height:t};let s=n*e,i=n*t,o=new Float32Array(3*s*i);for(let c=0;c<i;c++){let l=(c+.5)/n-.5,f=Math.floor(l),p=l-f,d=[Math.max(f,0),Math.min(f+1,t-1)];for(let _=0;_<s;_++){let w=(_+.5)/n-.5,A=Math.floor(w),R=w-A,L=[(A+e)%e,(A+1)%e];for(let H=0;H<3;H++){let Z=(xe,Te)=>r[3*(d[xe]*e+L[Te])+H],K=Z(0,0)+R*(Z(0,1)-Z(0,0)),Q=Z(1,0)+R*(Z(1,1)-Z(1,0));o[3*(c*s+_)+H]=K+p*(Q-K)}}}return{rgb:o,width:s,height:i}}function vf({width:r,height:e}){let t=new Float64Array(e),n=new Int32Array(e);for(let s=0;s<e;s++){let i=Math.PI*(s+.5)/e;t[s]=2*Math.PI/r*(Math.cos(Math.PI*s/e)-Math.cos(Math.PI*(s+1)/e)),n[s]=Math.min(Ce[0]-1,Math.floor((1-Math.cos(i))/2*Ce[0]))}return{width:r,height:e,solid:t,rows:n}}var fa=({rows:r,width:e},t,n)=>r[t]*Ce[1]+Math.floor(n/e*Ce[1]);function yf(r,e){let t=new Float64Array(3*yt),n=new Float64Array(yt),s=new Float64Array(3*yt);for(let o=0,c=0;o<e.height;o++){let l=Math.PI*(o+.5)/e.height,f=e.solid[o],p=Math.sin(l),d=Math.cos(l);for(let _=0;_<e.width;_++,c+=3){let w=fa(e,o,_),A=2*Math.PI*(_+.5)/e.width-Math.PI;n[w]+=f;for(let L=0;L<3;L++)t[3*w+L]+=r[c+L]*f;let R=ze(r,c/3)*f;s[3*w]+=R*p*Math.sin(A),s[3*w+1]+=R*d,s[3*w+2]-=R*p*Math.cos(A)}}return{flux:t.map((o,c)=>o/n[Math.floor(c/3)]*(4*Math.PI/yt)),sums:t,directions:s}}var ze=(r,e)=>(r[3*e]+r[3*e+1]+r[3*e+2])/3;function wf(r){let e=pf*r.reduce((n,s)=>n+s,0)/r.length,t=Float64Array.from({length:yt},(n,s)=>Math.max(0,1-e/Math.max(ze(r,s),1e-30)));return{share:t,excess:r.map((n,s)=>n*t[Math.floor(s/3)])}}function yn(r){let e=1-2*(Math.floor(r/Ce[1])+.5)/Ce[0],t=Math.sqrt(1-e*e),n=2*Math.PI*(r%Ce[1]+.5)/Ce[1]-Math.PI;return[t*Math.sin(n),e,-t*Math.cos(n)]}var Ts=(r,e)=>r[0]*e[0]+r[1]*e[1]+r[2]*e[2];function Is(r,e){let t=[0,0,0],n=0;for(let i of r){let o=ze(e,i);n+=o,yn(i).forEach((c,l)=>{t[l]+=o*c})}let s=Math.hypot(...t)||1;return{flux:n,size:s,direction:t.map(i=>i/s)}}function xf(r){let e=[];for(let s=0;s<yt;s++)ze(r,s)>0&&e.push(s);e.sort((s,i)=>ze(r,i)-ze(r,s));let t=[],n=s=>e.filter(i=>Ts(yn(i),s)>df);for(;e.length&&t.length<ca;){let i=e.slice(0,mf).map(c=>Is(n(yn(c)),r)).reduce((c,l)=>l.flux>c.flux?l:c),o=new Set(n(i.direction));t.push([...o]),e=e.filter(c=>!o.has(c))}for(;t.length&&t.length<ca&&bf(t,r););return t}function bf(r,e){let t=d=>{let{flux:_,size:w}=Is(d,e);return _-w},n=r.reduce((d,_)=>t(_)>t(d)?_:d),{direction:s}=Is(n,e),i=Af(n,e,s),o=n.map(d=>Ts(yn(d),i)),c=0,l=0;n.forEach((d,_)=>{c+=ze(e,d)*o[_],l+=ze(e,d)});let[f,p]=[!0,!1].map(d=>n.filter((_,w)=>o[w]*l>c===d));return!f.length||!p.length?!1:(r.splice(r.indexOf(n),1,f,p),!0)}function Af(r,e,t){let n=[[0,0,0],[0,0,0],[0,0,0]];for(let i of r){let o=yn(i).map((l,f)=>l-t[f]),c=ze(e,i);for(let l=0;l<3;l++)for(let f=0;f<3;f++)n[l][f]+=c*o[l]*o[f]}let s=[.6,.5,.62];for(let i=0;i<60;i++){let o=n.map(l=>Ts(l,s)),c=Math.hypot(...o);if(!c)break;s=o.map(l=>l/c)}return s}function Ef(r,e,t,n){let s=[0,1,2].map(c=>r.reduce((l,f)=>l+t(3*f+c),0)),i=[0,0,0];for(let c of r){let l=n.subarray(3*c,3*c+3),f=ze(e,c)/Math.hypot(...l);l.forEach((p,d)=>{i[d]+=f*p})}let o=Math.hypot(...i);return{direction:i.map(c=>c/o),colour:s}}function Rf(r,e,t){let[n,s]=la,i=new Float64Array(3*n*s),o=new Float64Array(n*s),c=[0,0,0];for(let l=0,f=0;l<e.height;l++){let p=Math.max(0,Math.cos(Math.PI*(l+.5)/e.height)),d=e.solid[l];for(let _=0;_<e.width;_++,f+=3){let w=Math.floor(l/e.height*n)*s+Math.floor(_/e.width*s),A=d*t(fa(e,l,_));o[w]+=d;for(let R=0;R<3;R++)i[3*w+R]+=A*r[f+R],c[R]+=A*p*r[f+R]}}return{radiance:i.map((l,f)=>l/o[Math.floor(f/3)]),up:c}}var kf={studio:["Studio",_i],white:["White from all sides",()=>Wn([1,1,1])]},Sf=[1.06,1,.9],gr=Math.PI/180,_r=class{constructor(){this.images=new Map(Object.entries(kf).map(([e,[t,n]])=>[e,{label:t,make:n}])),this.choice="studio",this.turntable=0,this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:[],imageTurn:0})}add(e,t){let n=`image-${this.images.size}`;return this.images.set(n,{label:e,make:()=>t}),n}tables(){let e=this.images.get(this.choice);return e.tables??=gi(e.make()),e.tables}get isPrepared(){return!(this.strength>0)||!!this.images.get(this.choice).first}async prepare(){let e=this.images.get(this.choice);e.first??=await(e.finding??=ua(e.make()))}firstLights(){if(!(this.strength>0))return null;let{lights:e,rest:t,up:n}=this.images.get(this.choice).first,s=this._turn(),i=c=>c.map(l=>l*this.strength),o=e.map(({direction:c,colour:l})=>({kind:"sun",direction:ha(c,s),colour:i(l)}));return[...this._suns(),...o,{kind:"mirror",colour:i(n),radiance:i([1,1,1]),turn:s,rest:t}]}lights(){let e=this._suns(),t=[0,0,0];for(let{direction:n,colour:s}of e)s.forEach((i,o)=>{t[o]+=i*Math.max(0,n[1])});if(this.strength>0){let n=[this.strength,this.strength,this.strength],s=this._turn();e.push({kind:"environment",colour:n,angle:s},{kind:"aroundPoint",colour:n,angle:s}),this.tables().up.forEach((i,o)=>{t[o]+=i*this.strength})}return{lights:e,irradiance:t}}_turn(){return(this.rotation+this.turntable+this.imageTurn)*gr}_suns(){let e=(this.rotation+this.turntable)*gr;return(this.suns??[this._sun()]).filter(({irradiance:t})=>t.some(n=>n>0)).map(({direction:t,irradiance:n})=>({kind:"sun",direction:ha(t,e),colour:n}))}_sun(){let e=this.sunHeight*gr,t=this.sunAzimuth*gr;return{direction:[Math.cos(e)*Math.sin(t),Math.sin(e),Math.cos(e)*Math.cos(t)],irradiance:Sf.map(n=>n*this.sun)}}};function ha([r,e,t],n){let s=Math.cos(n),i=Math.sin(n),o=Math.hypot(r,e,t);return[(s*r+i*t)/o,e/o,(s*t-i*r)/o]}var pa=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),If=[[.59719,.35458,.04823],[.076,.90834,.01566],[.0284,.13383,.83777]],Tf=[[1.60475,-.53108,-.07367],[-.10208,1.10813,-.00605],[-.00327,-.07276,1.07602]];function Nf(r){let e=If.map(t=>{let n=1.461926*pa(t,r);return(n*(n+.0245786)-90537e-9)/(n*(.983729*n+.432951)+.238081)});return Tf.map(t=>pa(t,e))}function da(r){let e=[...r];for(let t=0;t<60;t++){let n=Nf(e);e=e.map((s,i)=>s*Math.min(2,Math.max(.5,r[i]/Math.max(n[i],1e-6))))}return e}var vr=class extends mr{constructor(e,t,n){super(e,t,n),Object.assign(this,{orbit:new Un,lighting:new _r,labels:{},ground:!1,scene:null,isTouched:!1}),Object.assign(this,{opened:null,shown:null,loading:null,lit:Promise.resolve(),placing:Promise.resolve()})}close(){this.loading?.abort(),this.end()}async open(e){this.loading?.abort();let t=this.loading=new AbortController,{signal:n}=t;try{this.notices.say(null,!1,"asset"),this.tell("loading");let s=(f,p)=>n.aborted||this.tell("progress",{got:f,all:p}),i=e instanceof Blob?new Et(e,e.name):await Fn.open(e,s,n,this.labels[en(e)]),o=await $t.open(i);n.throwIfAborted();let c=this.settings.tier,l=this._known(o,c);await this.begun&&o.prefetch(l,this.settings.firstLook!=="off"),await this._offerPoster(o),await this._show(o,l,!0,n),this.settings.tier!==c&&await this._show(o,this._known(o,this.settings.tier),!1,n)}catch(s){n.aborted||this.failed(s,"asset")}finally{this.loading===t&&(this.loading=null,this.tell("ended"))}}async switchTier(e){try{this.notices.say(null,!1,"asset"),await this._show(this.opened,this._known(this.opened,e),!1)}catch(t){this.failed(t,"asset")}finally{this.tell("ended")}}_known({manifest:e},t){let n=e.tiers.map(i=>i.name),s=t===null||n.includes(t);return this.notices.say(s?null:`tier: expected ${n.join(" or ")}, found ${JSON.stringify(t)}`,!0,"tier"),s?t:null}async openScene(e){try{let t=Of(await Ns(e),e),{radiance:n,image:s}=t.environment??{},i=o=>new URL(Ci(o),new URL(e,document.baseURI)).href;if(t.asset&&(t.asset=i(t.asset)),n&&(t.environment.key=this.lighting.add("The scene's",Wn(n))),s){let o=this.labels[s]??s;t.environment.key=this.lighting.add(o,ts(await Ns(i(s)),s))}return this.scene=t,this.reset(),t}catch(t){return this.failed(t,"scene"),null}}leaveScene(){this.scene=null,this.reset()}openImage(e,t){return this.lit=this._openImage(e,t)}async _openImage(e,t){let n=this.requestedImage={};try{this.notices.say(null,!1,"light");let s=e instanceof Blob?await e.arrayBuffer():await Ns(e);if(n!==this.requestedImage)return;this.setLight({choice:this.lighting.add(this.labels[t]??t,ts(s,t))})}catch(s){n===this.requestedImage&&this.failed(s,"light")}}chooseImage(e){this.requestedImage=null,this.setLight({choice:e})}setLight(e,{moving:t=!1,byUser:n=!1}={}){Object.assign(this.lighting,e),this.tell("set"),this.tell("light",{byUser:n}),this.changed(t)}changed(e=!1){if(!this.viewer)return;if(this.engine.hasLobes&&!this.lighting.isPrepared)return void this.lighting.prepare().then(()=>this.changed(e));let{lights:t,irradiance:n}=this.lighting.lights();t.some(({kind:s})=>s==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded)),this.viewer.lights=t,this.viewer.firstLights=this.engine.hasLobes?this.lighting.firstLights():null,this.viewer.ground=this._ground(n),this.viewer.restart(e)}reset(){let{ground:e,exposure:t,view:n}=this.scene??{},{settings:s}=this;this.placeCamera(),this.placeLights(),this.ground=s.ground??e??this.ground,this.setExposure(s.exposure??t??this.look.exposure),this.setView(s.viewTransform??n??this.look.view)}placeCamera(){let{position:e,look_at:t,vertical_fov_deg:n}=this.scene?.camera??{},{settings:s}=this,i=[e?Vs(e,t,n):{},s.cameraOrbit??{},{target:s.cameraTarget,fov:s.fieldOfView}];this.isTouched=!1;let{width:o,height:c}=this.canvas??{width:1,height:1};this.orbit.place(i,this.box,o/c,s.autoRotate),this.tell("camera",{byUser:!1}),this.viewer?.restart()}placeLights(){let{suns:e,environment:t}=this.scene??{},{sun:n,lightRotation:s,environmentIntensity:i}=this.settings,{lighting:o}=this;if(o.reset(),e&&(o.suns=e),t){let{key:c,strength:l=1,rotation_deg:f=0}=t,p=!this.settings.environment&&c||o.choice;Object.assign(o,{choice:p,strength:l,imageTurn:f})}n&&Object.assign(o,n,{suns:null}),this.setLight({rotation:zn(s??0),strength:i??o.strength})}turnTable(e,t){this.orbit.turntable=-e,this.lighting.turntable=-e*180/Math.PI,this.changed(t)}setExposure(e,t=!0){this._setLook({exposure:e},t&&this.ground)}setView(e){this._setLook({view:e},this.ground)}setBackdrop(e){this._setLook({backdrop:e},this.ground)}setDenoise(e){this._setLook({denoise:e})}setSampling(e){this._setLook(e),this.viewer?.restart()}setGround(e){this.ground=e,this.changed()}_setLook(e,t=!1){Object.assign(this.look,e),Object.assign(this.viewer??{},e),this.tell("set"),t&&this.changed(),this.viewer?.show()}async _show(e,t,n,s){if(!await this.begun)return;let i=await e.load(t,{wantsLobes:this.settings.firstLook!=="off"});e.forget(),performance.mark("package"),await this.lit,await this.begun&&(this.placing=this.placing.catch(()=>{}).then(()=>this._place(e,i,n,s)),await this.placing)}async _place(e,t,n,s){if(s?.throwIfAborted(),!this.viewer||!n&&this.opened!==e)return;n&&(this.viewer.hasShown=!1),this.viewer.pause();let i=n?await Yn(t.parts):this.arrays;if(t.parts.every(({environment:c})=>c)&&await this.lighting.prepare(),s?.throwIfAborted(),performance.mark("hierarchy"),!await this._upload(i,t))return;performance.mark("asset"),Object.assign(this,{opened:e,shown:t,arrays:i,box:i.box,isNew:n}),n&&this.scene?this.reset():n&&this.placeCamera();let{warnings:o}=e.manifest;o.length&&this.notices.say(o.join("; "),!0,"asset"),this.tell("package",{opened:e,shown:t}),this.viewer.stats.ms=0,this.changed(),this.viewer.start()}async _upload(e,{parts:t}){for(;await this.begun&&this.engine;){let{engine:n}=this;try{if(await n.setAsset(e,t),n===this.engine)return!0}catch(s){if(n===this.engine)throw s}}return!1}async restore(e){this.uploaded=null,this.shown&&(this.viewer.hasShown=!0,await e.setAsset(this.arrays,this.shown.parts),this.changed(),this.viewer?.start())}resized(){this.shown&&!this.isTouched&&this.placeCamera()}pictured(){this.tell("shown"),this.isNew&&(this.isNew=!1,this.tell("load"))}async _offerPoster(e){try{this.tell("poster",{blob:await e.posterImage()})}catch{}}_ground(e){let{view:t,exposure:n,backdrop:s}=this.look;if(this.notices.say(this.ground&&!s?"ground: expected an opaque background-color":null,!0,"ground"),!this.ground||!s||!this.box)return null;let i=t==="filmic"?da(s):s,{min:o,max:c}=this.box,l=Math.hypot(...c.map((f,p)=>f-o[p]));return{height:o[1]-1e-4*l,x:(o[0]+c[0])/2,z:(o[2]+c[2])/2,size:2*l,colour:i.map((f,p)=>e[p]>0?f/e[p]/2**n:0)}}};function Of(r,e){try{return JSON.parse(new TextDecoder().decode(r))}catch(t){throw new G(`${e}: expected a scene.json, found ${Nt(new Uint8Array(r))??t.message}`)}}async function Ns(r){let e=await fetch(r).catch(()=>null);if(!e?.ok)throw new G(`cannot load ${r}${e?`: HTTP ${e.status}`:""}`);return e.arrayBuffer()}var yr=class{constructor(e){Object.assign(this,{stage:e,angle:0,isOn:!1,isTurning:!1,delay:3e3,speed:30}),e.addEventListener("shown",()=>this._next());for(let t of["load","camera","light"])e.addEventListener(t,()=>this.wait())}wait(){clearTimeout(this.timer);let e=this.isTurning;this.isTurning=!1,this.isOn?this.timer=setTimeout(()=>this._start(),this.delay):e&&this.stage.viewer?.restart()}switch(e){this.isOn=e,this.wait()}set(e){this.angle=e,this.stage.turnTable(e,this.isTurning)}_start(){Object.assign(this,{isTurning:!0,last:performance.now()}),this._next()}_next(){!this.isTurning||this.isRequested||(this.isRequested=!0,requestAnimationFrame(e=>{if(this.isRequested=!1,!this.isTurning)return;let t=Math.min(.25,Math.max(0,e-this.last)/1e3);this.last=e,this.set(this.angle+t*this.speed*Math.PI/180)}))}};var Mf=["studio","white"],Lf="50% 0px",Pf=500,Ff={src:"asset",environment:"light",scene:"scene"},wr=class extends HTMLElement{static observedAttributes=Object.keys(rn);constructor(){super();let e=Qs(this),t=n=>e.getElementById(n);this.parts={view:t("view"),poster:t("poster"),image:e.querySelector("img"),loading:t("loading"),bar:t("bar"),bytes:t("bytes"),status:t("status"),tint:t("tint")},this.settings=Object.fromEntries(Object.keys(rn).map(n=>[$n(n),null])),this.notices=new Cn(t("notice")),this.stage=new vr(this.parts.view,this.notices,this.settings),this.turntable=new yr(this.stage),this.stillness=matchMedia("(prefers-reduced-motion: reduce)"),Object.assign(this,{loaded:!1,observer:null,isNear:!1,isDismissed:!1,isBegun:!1,asked:null,failures:new Set}),this._listen()}connectedCallback(){this.stage.labels=JSON.parse(this.dataset.labels??"{}"),this.observer=new IntersectionObserver(e=>this._seen(e.at(-1).isIntersecting),{rootMargin:Lf}),this.observer.observe(this),this.stillness.addEventListener("change",this.onstillness=()=>this._turn()),this._turn(),this._tint(),this._begin()}disconnectedCallback(){this.observer.disconnect(),this.stillness.removeEventListener("change",this.onstillness),queueMicrotask(()=>{this.isConnected||!this.isBegun||(this.stage.loading&&(this.asked=null),this.isBegun=!1,this.turntable.switch(!1),this.stage.close())})}attributeChangedCallback(e,t,n){let s=this.failures.delete(Ff[e]);if(t===n&&!s)return;e==="src"&&(this.asked=null);let i=$n(e);try{this.settings[i]=n===null?null:rn[e](n),this.notices.say(null,!0,e)}catch(o){this.settings[i]=null,this.notices.say(`${e}: ${o.message}`,!0,e)}this._apply(e)}get availableTiers(){return this.stage.opened?.manifest.tiers.map(({name:e})=>e)??[]}get turntableRotation(){return this.turntable.angle}resetTurntableRotation(e=0){this.turntable.set(e)}resetView(){this.stage.reset()}showPoster(){this.isDismissed=!1,this.parts.poster.hidden=!1}dismissPoster(){this.isDismissed=!0,this._begin(),this.loaded&&this._hidePoster()}async toBlob({mimeType:e="image/png",qualityArgument:t,converged:n=!1}={}){let{stage:s}=this;return!s.viewer||!this.loaded?null:(n&&await s.viewer.converged(),s.screenshot(e,t))}_seen(e){this.isNear=e,this.stage.rest(!e),this._tint(),this._begin()}_apply(e){let{stage:t,settings:n}=this;e==="src"&&this._begin(),e==="poster"&&this._showImage(n.poster),e==="scene"&&this.isBegun&&this._openScene(),e==="environment"&&this.isBegun&&this._light(),e==="tier"&&t.opened&&!t.loading&&t.switchTier(n.tier),e==="first-look"&&t.shown&&t.switchTier(t.shown.name),e==="samples"&&t.setSampling({rounds:n.samples??256}),e==="jitter"&&t.setSampling({jitter:n.jitter??1}),["camera-orbit","camera-target","field-of-view"].includes(e)&&t.placeCamera(),["sun","light-rotation","environment-intensity"].includes(e)&&t.placeLights(),e==="ground"&&t.setGround(n.ground??t.scene?.ground??!1),e==="exposure"&&t.setExposure(n.exposure??t.scene?.exposure??0),e==="view-transform"&&t.setView(n.viewTransform??t.scene?.view??"srgb"),e==="pixel-ratio"&&t.resize(),["loading","reveal"].includes(e)&&this._begin(),(e.startsWith("auto-rotate")||e==="rotation-per-second")&&this._turn(),this._describe()}_begin(){let{stage:e,settings:t}=this,n=t.reveal!=="manual"||this.isDismissed;if(this.parts.image.loading=t.loading==="eager"?"eager":"lazy",!(!this.isConnected||!this.observer||!(t.loading==="eager"||this.isNear&&n))){if(!this.isBegun&&(this.isBegun=!0,e.begin(),this._turn(),t.environment&&!this.isLit&&this._light(),t.scene))return void this._openScene();t.src!==this.asked&&this._open()}}_open(){this.asked=this.settings.src,this.asked!==null&&(this.loaded=!1,this.stage.open(this.asked))}async _openScene(){let e=this.requestedScene=this.settings.scene;if(e===null)return this.stage.leaveScene();let t=await this.stage.openScene(e);e===this.requestedScene&&(this.settings.src?this._begin():t?.asset&&this.stage.open(t.asset))}_light(){let{environment:e}=this.settings;this.isLit=!0,e!==null&&!Mf.includes(e)?this.stage.openImage(e,en(e)):this.stage.chooseImage(e??"studio")}_tint(){this.stage.setBackdrop(Js(getComputedStyle(this.parts.tint).backgroundColor))}_turn(){let{autoRotate:e,autoRotateDelay:t,rotationPerSecond:n}=this.settings;Object.assign(this.turntable,{delay:t??3e3,speed:n??30}),this.turntable.switch(!!e&&this.isBegun&&!this.stillness.matches)}_listen(){let{stage:e,parts:t}=this,n=(s,i)=>e.addEventListener(s,i);t.tint.addEventListener("transitionend",()=>this._tint()),n("engine",()=>this._describe()),n("progress",({got:s,all:i})=>this._showProgress(s,i)),n("poster",({blob:s})=>this.settings.poster||this._showImage(s&&URL.createObjectURL(s))),n("package",()=>this._describe()),n("loading",()=>this.failures.delete("asset")),n("load",()=>{this.loaded=!0,(this.settings.reveal!=="manual"||this.isDismissed)&&this._hidePoster(),t.status.textContent=`${this._name()} is shown`,this._fire("progress",{totalProgress:1}),this._fire("load",{url:this.asked})}),n("ended",()=>{t.loading.hidden=!0}),n("failed",({error:s,about:i})=>{this.failures.add(i),i==="engine"&&(t.poster.hidden=!1),this._fire("error",{type:i,message:s.message,code:s.code??null,sourceError:s})}),n("camera",({byUser:s})=>{this._fire("camera-change",{...sn(e.orbit),source:s?"user-interaction":"none"}),s&&this._speak()}),n("light",({byUser:s})=>this._fire("light-change",{...Gn(e.lighting),source:s?"user-interaction":"none"}))}_speak(){clearTimeout(this.speaking),this.speaking=setTimeout(()=>{this.parts.status.textContent=ti(this.stage.orbit)},Pf)}_showProgress(e,t){let{loading:n,bar:s,bytes:i}=this.parts;n.hidden=!1,t?Object.assign(s,{max:Math.max(t,e),value:e}):s.removeAttribute("value"),i.textContent=t?`${ht(e)} of ${ht(Math.max(t,e))}`:ht(e),this._fire("progress",{totalProgress:t?Math.min(.99,e/t):0})}_showImage(e){let{image:t,poster:n}=this.parts;t.src.startsWith("blob:")&&URL.revokeObjectURL(t.src),t.hidden=!e,e?t.src=e:t.removeAttribute("src"),e&&(n.hidden=!1)}_hidePoster(){let{poster:e}=this.parts;e.hidden||(e.hidden=!0,this._fire("poster-dismissed"))}_name(){return this.settings.alt??this.stage.opened?.manifest.name??"A relightable asset"}_describe(){let{canvas:e}=this.stage,{cameraControls:t,touchAction:n}=this.settings;if(this.parts.image.alt=this._name(),!e)return;e.style.touchAction=t?n??"pan-y":"auto";let s=t?{role:"application",tabindex:0,"aria-describedby":"keys"}:{role:"img"};e.setAttribute("aria-label",this._name());for(let i of["role","tabindex","aria-describedby"])i in s?e.setAttribute(i,s[i]):e.removeAttribute(i)}_fire(e,t=null){this.dispatchEvent(new CustomEvent(e,{detail:t}))}},Cf={cameraOrbit:({stage:r})=>sn(r.orbit).cameraOrbit,cameraTarget:({stage:r})=>sn(r.orbit).cameraTarget,fieldOfView:({stage:r})=>sn(r.orbit).fieldOfView,sun:({stage:r})=>Gn(r.lighting).sun,lightRotation:({stage:r})=>Gn(r.lighting).lightRotation,environmentIntensity:({stage:r})=>r.lighting.strength,exposure:({stage:r})=>r.look.exposure,viewTransform:({stage:r})=>r.look.view,tier:({stage:r,settings:e})=>r.shown?.name??e.tier};for(let[r,e]of Object.entries(rn)){let t=$n(r),n=e===Ve;Object.defineProperty(wr.prototype,t,{get(){return Cf[t]?.(this)??(n?this.settings[t]===!0:this.settings[t])},set(s){n?this.toggleAttribute(r,!!s):s==null?this.removeAttribute(r):this.setAttribute(r,s)},enumerable:!0,configurable:!0})}customElements.get("rna-viewer")||customElements.define("rna-viewer",wr);})();
/*! Bundled license information:

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
