(()=>{var ua=Object.defineProperty;var gi=(n,e)=>{for(var t in e)ua(n,t,{get:e[t],enumerable:!0})};var Lt=class extends Error{constructor(e,t,r){super(`${t?t+": ":""}${r} [${e}]`),this.code=e,this.where=t}};function y(n,e,t){throw new Lt(n,e,t)}var B=class extends Error{};var cr=65536,fa=2**30,lt=class{constructor(e,t){this.blob=e,this.name=t,this.size=e.size,this.ranged=!1,this.fetched=e.size}async read(e,t){return new Uint8Array(await this.blob.slice(e,t).arrayBuffer())}},yn=class n{static async open(e,t=()=>{},r,i=lr(e)){let s=new n;Object.assign(s,{url:e,progress:t,signal:r,fetched:0,name:i});let a=await s._ask({Range:`bytes=0-${cr-1}`}),c=/\/(\d+)$/.exec(a.headers.get("Content-Range")??"");s.ranged=a.status===206&&c!==null;let l=Number(a.headers.get("Content-Length"))||0;s.expected=s.ranged?cr:l;let h=s.ranged?cr:fa;return l>h&&await s._tooLong(a,h),s.head=await s._collect(a,h),s.size=s.ranged?Number(c[1]):s.head.length,s}async read(e,t){if(t<=this.head.length)return this.head.subarray(e,t);if(!this.ranged)return this.head.subarray(e,Math.min(t,this.size));let r=await this._ask({Range:`bytes=${e}-${t-1}`});if(r.status!==206)throw new B(`${this.name}: the server forgot about ranges`);let i=await this._collect(r,t-e);if(i.length<t-e)throw new B(`${this.name}: the server sent ${i.length} bytes of ${t-e}`);return i}async _ask(e){let t;try{t=await fetch(this.url,{headers:e,signal:this.signal})}catch(r){if(r.name==="AbortError")throw r;let i=new URL(this.url,location.href).protocol==="file:";throw new B(i?"a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here":`cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`)}if(!t.ok&&t.status!==416)throw new B(`cannot load ${this.url}: HTTP ${t.status}`);return t}async _collect(e,t){if(e.status===416||!e.body)return new Uint8Array;let r=[],i=0,s=e.body.getReader();for(;;){let{done:l,value:h}=await s.read();if(l)break;i+=h.length,i>t&&await this._tooLong(s,t),r.push(h),this.fetched+=h.length,this.progress(this.fetched,this.expected)}let a=new Uint8Array(i),c=0;for(let l of r)a.set(l,c),c+=l.length;return a}async _tooLong(e,t){throw await(e.body??e).cancel().catch(()=>{}),new B(this.ranged?`${this.name}: the server sent more than the ${t} bytes that were asked for`:`${this.name}: more than ${t} bytes from a server without range requests: use rna-view, or a server that has them`)}};function lr(n){let e=new URL(n,location.href).pathname.split("/").pop();try{return decodeURIComponent(e)||n}catch{return e}}var Q=n=>document.getElementById(n);function ue(n,e,t){Q(n).addEventListener(e,({target:r})=>t(r))}var ur=new Map;function Ae(n,e=!1,t="page"){n?ur.set(t,{text:n,calm:e}):ur.delete(t);let r=Q("notice"),i=[...ur.values()];r.hidden=!i.length,r.replaceChildren(...i.map(({text:s})=>Object.assign(document.createElement("span"),{textContent:s}))),r.classList.toggle("calm",i.every(s=>s.calm))}var vi=(n,e,t)=>Math.min(Math.max(n,e),t),yi=n=>((n+180)%360+360)%360-180;function wn(n,e){let t=Math.abs(n).toFixed(e);return Number(t)===0?t:(n<0?"\u2212":"+")+t}function ut(n,e,t){Q(n).value=e,Q(`${n}-value`).textContent=t}function qe(n){return n<1e6?`${Math.round(n/1e3)} kB`:`${(n/1e6).toFixed(n<1e7?2:1)} MB`}function fr(n){return n<10?`${n.toFixed(1)} ms`:n<1e3?`${Math.round(n)} ms`:`${(n/1e3).toFixed(1)} s`}function _i(n,e=0){let t=n.length/6,r=Uint32Array.from({length:t},(p,m)=>m),i=new Float32Array(3*t);for(let p=0;p<t;p++)for(let m=0;m<3;m++)i[3*p+m]=.5*(n[6*p+m]+n[6*p+3+m]);let s=new Float32Array(16*t),a=new Uint32Array(s.buffer),c={boxes:n,centres:i,order:r},l=[[0,t,0,-1]],h=0;for(;l.length;){let[p,m,v,b]=l.pop(),S=8*h;h+=1,b>=0&&(a[b+3]=e+S/8),ha(c,p,m);for(let L=0;L<3;L++)s[S+L]=ve[L],s[S+4+L]=ve[3+L];if(m-p<=4){a[S+3]=p,a[S+7]=m-p;continue}let T=v<24?ma(c,p,m):p;p<T&&T<m||(T=da(c,p,m)),l.push([T,m,v+1,S],[p,T,v+1,-1])}return{nodes:a.slice(0,8*h),order:r}}function gr(n,e,t,r){for(let i=0;i<3;i++)n[e+i]=Math.min(n[e+i],t[r+i]),n[e+3+i]=Math.max(n[e+3+i],t[r+3+i])}function vr(n){for(let e=0;e<n.length;e+=6)for(let t=0;t<3;t++)n[e+t]=1/0,n[e+3+t]=-1/0;return n}var ve=new Float32Array(6),mr=new Float32Array(96),dr=new Uint32Array(16),hr=new Float64Array(16),pr=new Float64Array(16);function ha({boxes:n,order:e},t,r){vr(ve);for(let i=t;i<r;i++)gr(ve,0,n,6*e[i])}function xi({centres:n,order:e},t,r,i){let s=1/0,a=-1/0;for(let c=t;c<r;c++){let l=n[3*e[c]+i];s=Math.min(s,l),a=Math.max(a,l)}return[s,a]}var bi=(n,e,t)=>Math.min(Math.floor((n-e)/(t-e)*16),15);function pa({boxes:n,centres:e,order:t},r,i,s,a,c){vr(mr),dr.fill(0);for(let p=r;p<i;p++){let m=bi(e[3*t[p]+s],a,c);dr[m]+=1,gr(mr,6*m,n,6*t[p])}wi(pr,15,-1),wi(hr,0,1);let l=1/0,h=0;for(let p=1;p<16;p++)hr[p-1]+pr[p]<l&&(l=hr[p-1]+pr[p],h=p);return{cost:l,cut:h,axis:s,low:a,high:c}}function wi(n,e,t){vr(ve);for(let r=e,i=0;r>=0&&r<16;r+=t){gr(ve,0,mr,6*r),i+=dr[r];let s=ve[3]-ve[0],a=ve[4]-ve[1],c=ve[5]-ve[2];n[r]=i?(s*a+a*c+c*s)*i:1/0}}function ma(n,e,t){let r={cost:1/0};for(let v=0;v<3;v++){let[b,S]=xi(n,e,t,v),T=S>b?pa(n,e,t,v,b,S):r;T.cost<r.cost&&(r=T)}if(r.cost===1/0)return e;let{centres:i,order:s}=n,{axis:a,cut:c,low:l,high:h}=r,p=e,m=t-1;for(;p<=m;){let v=s[p];bi(i[3*v+a],l,h)<c?p++:(s[p]=s[m],s[m--]=v)}return p}function da(n,e,t){let{centres:r,order:i}=n,s=[0,1,2].map(c=>{let[l,h]=xi(n,e,t,c);return h-l}),a=s.indexOf(Math.max(...s));return i.subarray(e,t).sort((c,l)=>r[3*c+a]-r[3*l+a]),Math.floor((e+t)/2)}var yr={note:"Generated by `python -m rna_gpu.records.write_records`; do not edit.",constants:{MAX_LAYERS:32,MAX_EXACT_INPUTS:512,UNIFORM_WEIGHTS:4096,RNA_NONE:4294967295,RNA_FLOAT32:0,RNA_FLOAT16:1,RNA_INT8:2,RNA_BLOCK_FEATURES:0,RNA_BLOCK_POSITION:1,RNA_BLOCK_NORMAL:2,RNA_BLOCK_TANGENT:3,RNA_BLOCK_H:4,RNA_BLOCK_WO:5,RNA_BLOCK_WI:6,RNA_BLOCK_HALF_VECTOR:7,RNA_BLOCK_HIGHLIGHT:8,RNA_BLOCK_LEARNED_NORMAL:9,RNA_BLOCK_FIBER_ANGLES:10,RNA_BLOCK_FIBER_LOBES:11,RNA_CHANNEL_GROUPS:16,NONE:4294967295,SUM_BEAUTY:0,SUM_NORMAL:1,SUM_POSITION:2,SUM_LIGHT_SAMPLES:3,SUM_BEHIND:4,SUM_GROUPS:5,CAMERA_RAY:1,SHADOW_RAY:4,ALL_DIRECTIONS:4294967295,HEMISPHERE:4294967294,CHOICES:1,DIRECTION:2,ROULETTE:3,LIGHT:4,DIMENSIONS:7,HAS_SKY:1,FOR_BETA:2,RAYS_MEET_LIGHTS:4,FOR_EMISSION:8,FOR_LIGHT:16,TRANSMITS:32,OF_MATERIAL:0,OF_NEURAL:1,OF_FIBERS:2,EMITS:1,LETS_THROUGH:2,IS_GLASS:4,HAS_CUTOFF:8,HAS_SCHLICK:16,BASE:0,METAL:1,COAT:2,GLOW:3,CLEAR:4,CLEAR_ROUGH:5,THROUGH:6,RELIEF:7,LIGHT_SEEN:1,LIGHT_DELTA:2,LIGHT_INFINITE:4,DIRECTIONAL:0,SUN:1,POINT:2,RECTANGLE:3,DISK:4,SPHERE:5,UNIFORM:6,IMAGE:7,TRIANGLES:8},records:{RnaLayer:{words:8,members:{inputs:{at:0,type:"u32",count:1},outputs:{at:1,type:"u32",count:1},weights:{at:2,type:"u32",count:1},bias:{at:3,type:"u32",count:1},units:{at:4,type:"u32",count:1},relu:{at:5,type:"u32",count:1},int8_step:{at:6,type:"f32",count:1},reserved:{at:7,type:"u32",count:1}}},RnaPart:{words:484,members:{low:{at:0,type:"f32",count:3},resolution:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},channel_groups:{at:7,type:"u32",count:1},query_groups:{at:8,type:"u32",count:1},layer_count:{at:9,type:"u32",count:1},plane_precision:{at:10,type:"u32",count:1},gain:{at:11,type:"u32",count:1},query_low:{at:12,type:"f32",count:1},query_high:{at:13,type:"f32",count:1},top:{at:14,type:"f32",count:1},unit:{at:15,type:"f32",count:1},matrix:{at:16,record:"RnaLayer",count:1},scales:{at:24,type:"f32",count:192},layers:{at:216,record:"RnaLayer",count:32},slots:{at:472,type:"u32",count:12}}},RnaNode:{words:8,members:{low:{at:0,type:"f32",count:3},child:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},count:{at:7,type:"u32",count:1}}},RnaInstance:{words:32,members:{to_object:{at:0,type:"f32",count:12},rotation:{at:12,type:"f32",count:12},place:{at:24,type:"f32",count:3},scale:{at:27,type:"f32",count:1},root:{at:28,type:"u32",count:1},rays:{at:29,type:"u32",count:1},extent:{at:30,type:"f32",count:1},own:{at:31,type:"u32",count:1}}},Frame:{words:36,members:{camera:{at:0,type:"f32",count:3},width:{at:3,type:"u32",count:1},corner:{at:4,type:"f32",count:3},paths:{at:7,type:"u32",count:1},step_x:{at:8,type:"f32",count:3},sample:{at:11,type:"u32",count:1},step_y:{at:12,type:"f32",count:3},seed:{at:15,type:"u32",count:1},depth:{at:16,type:"u32",count:1},light:{at:17,type:"u32",count:1},part:{at:18,type:"u32",count:1},parts:{at:19,type:"u32",count:1},rays:{at:20,type:"u32",count:1},clamp:{at:21,type:"f32",count:1},light_count:{at:22,type:"u32",count:1},sums:{at:23,type:"u32",count:1},flags:{at:24,type:"u32",count:1},branch:{at:25,type:"u32",count:1},branches:{at:26,type:"u32",count:1},neural_part:{at:27,type:"u32",count:1},table_size:{at:28,type:"u32",count:1},things:{at:29,type:"u32",count:1},surfaces:{at:30,type:"u32",count:1},lights:{at:31,type:"u32",count:1},albedo:{at:32,type:"u32",count:1},domains:{at:33,type:"u32",count:1},textures:{at:34,type:"u32",count:1}}},Path:{words:24,members:{origin:{at:0,type:"f32",count:3},pixel:{at:3,type:"u32",count:1},direction:{at:4,type:"f32",count:3},pdf:{at:7,type:"f32",count:1},beta:{at:8,type:"f32",count:3},state:{at:11,type:"u32",count:1},normal:{at:12,type:"f32",count:3},t:{at:15,type:"f32",count:1},instance:{at:16,type:"u32",count:1},primitive:{at:17,type:"u32",count:1},own:{at:18,type:"u32",count:1},b1:{at:19,type:"f32",count:1},leaving:{at:20,type:"f32",count:3},b2:{at:23,type:"f32",count:1}}},Pending:{words:24,members:{x:{at:0,type:"f32",count:3},h:{at:3,type:"f32",count:1},axis:{at:4,type:"f32",count:3},part:{at:7,type:"u32",count:1},wo:{at:8,type:"f32",count:3},light:{at:11,type:"u32",count:1},wi:{at:12,type:"f32",count:3},strand:{at:15,type:"u32",count:1},weight:{at:16,type:"f32",count:3},seen:{at:19,type:"f32",count:1},visible:{at:20,type:"f32",count:3},reserved:{at:23,type:"u32",count:1}}},Thing:{words:4,members:{number:{at:0,type:"f32",count:1},catches:{at:1,type:"u32",count:1},step:{at:2,type:"f32",count:1},passes:{at:3,type:"u32",count:1}}},Surface:{words:36,members:{kind:{at:0,type:"u32",count:1},part:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},normal_map:{at:3,type:"u32",count:1},base_color:{at:4,type:"f32",count:3},roughness:{at:7,type:"f32",count:1},metallic:{at:8,type:"f32",count:1},coat_f0:{at:9,type:"f32",count:1},coat_weight:{at:10,type:"f32",count:1},transmission:{at:11,type:"f32",count:1},emission:{at:12,type:"f32",count:3},normal_scale:{at:15,type:"f32",count:1},clear_coat:{at:16,type:"f32",count:1},clear_coat_roughness:{at:17,type:"f32",count:1},second_uvs:{at:18,type:"u32",count:1},tangents:{at:19,type:"u32",count:1},textures:{at:20,type:"u32",count:8},through:{at:28,type:"u32",count:1},cutoff:{at:29,type:"f32",count:1},ior:{at:30,type:"f32",count:2},f0:{at:32,type:"f32",count:1}}},Texture:{words:12,members:{place:{at:0,type:"u32",count:1},size:{at:1,type:"u32",count:1},form:{at:2,type:"u32",count:1},row_u:{at:4,type:"f32",count:3},row_v:{at:8,type:"f32",count:3}}},Light:{words:32,members:{kind:{at:0,type:"u32",count:1},group:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},instance:{at:3,type:"u32",count:1},numbers:{at:4,type:"f32",count:20},probability:{at:24,type:"f32",count:3},places:{at:28,type:"u32",count:4}}}},lights:{directional:{colour:0,axis:3},sun:{colour:0,axis:3,one_minus_cosine:6},point:{colour:0,place:3,axis:6,cos_inner:9,cos_outer:10},rectangle:{colour:0,frame:3,half:15},disk:{colour:0,frame:3,radius:15},sphere:{colour:0,centre:3,radius:6},uniform:{colour:0},image:{colour:0,turn_cosine:3,turn_sine:4,total:5,mean:6,rows:7,columns:8},triangles:{colour:0,rotation:3,place:12,scale:15}}};var{constants:ie,records:Ee}=yr;function Ai(n){for(let[,e,t]of n.matchAll(/struct (\w+) \{([^}]*)\}/g)){let r={},i=0;for(let[,s,a]of t.matchAll(/^\s*(\w+): ([\w<>]+)/gm)){let c=Number(/vec(\d)/.exec(a)?.[1]??1),l=c===3?4:c,h=Math.ceil(i/l)*l;r[s]={at:h,type:a.includes("u32")?"u32":"f32",count:c},i=h+c}Ee[e]={words:4*Math.ceil(i/4),members:r}}}function fe(n,e){let t=new Uint32Array(Ee[n].words);return Ri(t,new Float32Array(t.buffer),0,n,e),t}var ft=n=>4*Ee[n].words;function Ei(n,e){let t=[];for(let[r,i]of Object.entries(e))[i].flat().forEach((s,a)=>{t[yr.lights[n][r]+a]=s});return Float32Array.from(t,r=>r??0)}function Ri(n,e,t,r,i){for(let[s,a]of Object.entries(i)){let{at:c,type:l,record:h}=Ee[r].members[s],p=t+c,m=typeof a=="number"?[a]:a;h?[m].flat().forEach((v,b)=>Ri(n,e,p+b*Ee[h].words,h,v)):(l==="f32"?e:n).set(m,p)}}var{NONE:va,OF_NEURAL:ya,OF_FIBERS:wa,LETS_THROUGH:ki,HAS_CUTOFF:_a}=ie,_n=class{constructor(){Object.assign(this,{surfaces:[],textures:[],images:[],imagesLength:0})}ofFibers(e){return this._add({kind:wa,part:e})}ofTriangles({mesh:e,transmittance:t,normalMaps:r},i){let s=e.indices.length/3,a=Si(t,s),c=Si(r,s),l=new Map,h=new Uint32Array(s);for(let p=0;p<s;p++){let m=`${c[p]} ${a[p]}`;l.has(m)||l.set(m,this._ofRecords(i,r[c[p]],t[a[p]])),h[p]=l.get(m)}return h}arrays(){let e=this.surfaces.map(s=>fe("Surface",s)),t=Uint32Array.from([...e,...this.textures].flatMap(s=>[...s])),r=new Uint32Array(this.imagesLength),i=0;for(let s of this.images)r.set(s,i),i+=s.length;return{table:t,images:r,texturesAt:e.reduce((s,a)=>s+a.length/4,0),hasTextures:this.textures.length>0,transmits:this.surfaces.some(({flags:s})=>s&ki)}}_add(e){return this.surfaces.push({normal_map:va,...e})-1}_ofRecords(e,t,r){let i={kind:ya,part:e};return t&&(i.normal_map=this._texture(t.texture)),r&&(i.flags=ki|(r.cutoff==null?0:_a),Object.assign(i,{through:this._texture(r.texture),cutoff:r.cutoff??0,ior:r.ior??[0,0]})),this._add(i)}_texture({values:e,width:t,height:r,channels:i}){let s=new Uint32Array(t*r),a=this.imagesLength;for(let c=0;c<s.length;c++){let[l,h=l,p=i===1?l:0]=e.subarray(i*c,i*(c+1));s[c]=l|h<<8|p<<16}return this.images.push(s),this.imagesLength+=s.length,this.textures.push(fe("Texture",{place:a,size:r<<16|t,row_u:[1,0,0],row_v:[0,1,0]}))-1}};function Si(n,e){let t=new Int32Array(e).fill(-1);return n.forEach(({triangles:[r,i]},s)=>t.fill(s,r,r+i)),t}var xa=1,ba=2;function xn(n){let e=n.map(Aa),t=p=>e.reduce((m,v)=>m+v[p],0),r={primitives:new Uint32Array(4*t("primitives")),points:new Float32Array(4*t("points")),normals:new Float32Array(4*t("normals")),boxes:new Float32Array(6*t("primitives")),surfaces:new _n,parts:[],extent:0,strands:0},i={primitive:0,point:0},s=[...n.keys()].sort((p,m)=>(n[p].kind==="fiber")-(n[m].kind==="fiber"));for(let p of s){let m=n[p];r.parts[p]={first:i.primitive,fiber:m.kind==="fiber"},m.kind==="fiber"?Ra(r,m.curves,p,i):Ea(r,m,p,i),i={primitive:i.primitive+e[p].primitives,point:i.point+e[p].points}}let{nodes:a,order:c}=_i(r.boxes,1),l=new Uint32Array(r.primitives.length),h=new Uint32Array(c.length);return c.forEach((p,m)=>{l.set(r.primitives.subarray(4*p,4*p+4),4*m),h[p]=m}),{...r,boxes:null,...r.surfaces.arrays(),primitives:l,nodes:ka(a),where:h,box:Sa(a)}}function Aa({kind:n,mesh:e,curves:t}){if(n==="surface"){let i=e.positions.length/3;return{primitives:e.indices.length/3,points:i,normals:i}}let r=t.radii.length;return{primitives:r-(t.offsets.length-1),points:r,normals:0}}function Ea(n,e,t,{primitive:r,point:i}){let{positions:s,normals:a,uvs:c,indices:l}=e.mesh,{points:h,boxes:p,primitives:m}=n;for(let b=0;b<s.length/3;b++){let S=4*(i+b);for(let T=0;T<3;T++)h[S+T]=s[3*b+T],n.normals[S+T]=a[3*b+T],n.extent=Math.max(n.extent,Math.abs(s[3*b+T]));h[S+3]=c?c[2*b]:0,n.normals[S+3]=c?c[2*b+1]:0}let v=n.surfaces.ofTriangles(e,t);for(let b=0;b<l.length/3;b++){let S=[0,1,2].map(T=>l[3*b+T]);m.set([...S.map(T=>T+i),2*v[b]],4*(r+b));for(let T=0;T<3;T++){let L=S.map(Y=>s[3*Y+T]);p[6*(r+b)+T]=Math.min(...L),p[6*(r+b)+3+T]=Math.max(...L)}}}function Ra(n,e,t,{primitive:r,point:i}){let{boxes:s,primitives:a}=n,{radii:c,offsets:l}=e,h=n.surfaces.ofFibers(t);for(let m=0;m<c.length;m++){let[v,b,S]=e.points.subarray(3*m,3*m+3);n.points.set([v,b,S,c[m]],4*(i+m)),n.extent=Math.max(n.extent,Math.max(Math.abs(v),Math.abs(b),Math.abs(S))+c[m])}let p=r;for(let m=0;m+1<l.length;m++,n.strands++)for(let v=l[m];v+1<l[m+1];v++,p++){let b=(v>l[m]&&xa)|(v+2<l[m+1]&&ba);a.set([i+v,b,n.strands,2*h+1],4*p);for(let S=0;S<3;S++){let T=e.points[3*v+S],L=e.points[3*v+3+S],Y=c[v]*1.0005,ee=c[v+1]*1.0005;s[6*p+S]=Math.min(T-Y,L-ee),s[6*p+3+S]=Math.max(T+Y,L+ee)}}}function ka(n){let e=new Uint32Array(n.length+8);return e.set(n.subarray(0,8)),e[3]=0,e[7]=1,e.set(n,8),e}function Sa(n){let e=new Float32Array(n.buffer,0,8);return{min:[...e.subarray(0,3)],max:[...e.subarray(4,7)]}}var Ti={blocks:[{name:"features",width:null,kinds:["surface","fiber"],light:!1},{name:"position",width:3,kinds:["surface","fiber"],light:!1},{name:"normal",width:3,kinds:["surface"],light:!1},{name:"tangent",width:3,kinds:["fiber"],light:!1},{name:"h",width:1,kinds:["fiber"],light:!1},{name:"wo",width:3,kinds:["surface","fiber"],light:!1},{name:"wi",width:3,kinds:["surface","fiber"],light:!0},{name:"half_vector",width:5,kinds:["surface"],light:!0},{name:"highlight",width:1,kinds:["surface"],light:!0},{name:"learned_normal",width:2,kinds:["surface"],light:!0},{name:"fiber_angles",width:6,kinds:["fiber"],light:!0},{name:"fiber_lobes",width:3,kinds:["fiber"],light:!0}]};var bn=Ti.blocks,Pt=n=>bn.find(e=>e.name===n),An=(n,e)=>Pt(n).width??e;var Ze=22,et=46,Dt=30,Ni=64,Oi=256,Na=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,ht="manifest.json",Ii=2**20,Bt=n=>new DataView(n.buffer,n.byteOffset,n.byteLength);async function Fi(n){let{size:e}=n;e===0&&y("FILE_EMPTY",n.name,"the file has no bytes"),e>2**32-2&&y("FILE_TOO_LARGE",n.name,`${e} bytes`);let{count:t,start:r}=await Oa(n),i=await n.read(r,e-Ze),s=Ma(i,t,r,n.name);return za(s,r,n.name),new Map(s.map(a=>[a.name,a]))}async function Oa(n){let{size:e,name:t}=n,r=Bt(await n.read(0,Math.min(4,e))),s=e>=4&&r.getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";e<Ze&&y(s,t,"shorter than the end record of a ZIP archive");let a=Bt(await n.read(e-Ze,e)),c=e===Ze&&a.getUint32(0,!0)===101010256;a.getUint32(0,!0)!==101010256&&await Ia(n,s);let l=v=>a.getUint16(v,!0);[4,6,8,10].some(v=>l(v)===65535)&&y("ZIP_ZIP64",t,"a ZIP64 archive"),(l(4)||l(6))&&y("ZIP_ZIP64",t,"an archive of several disks");let h=l(10),p=a.getUint32(12,!0),m=a.getUint32(16,!0);return h>Oi&&y("ZIP_TOO_MANY",t,`${h} entries; at most ${Oi}`),(l(8)!==h||l(20)!==0||m+p!==e-Ze)&&y("ZIP_DIRECTORY",t,"the end record does not fit the central directory"),(c||h===0)&&y("ZIP_ORDER",t,`${ht} is not the first entry`),{count:h,start:m}}async function Ia(n,e){let t=await n.read(Math.max(0,n.size-Ze-65535),n.size),r=Bt(t);for(let i=t.length-Ze;i>=0;i--)r.getUint32(i,!0)===101010256&&i+Ze+r.getUint16(i+20,!0)===t.length&&y("ZIP_DIRECTORY",n.name,"the archive has a comment");y(e,n.name,"the file does not end with the end record of a ZIP archive")}function Ma(n,e,t,r){let i=Bt(n),s=[],a=new Set,c=0;for(let l=0;l<e;l++){(c+et>n.length||i.getUint32(c,!0)!==33639248)&&y("ZIP_DIRECTORY",r,`the central directory has no header ${l}`);let h=i.getUint16(c+28,!0);(c+et+h>n.length||i.getUint32(c+30,!0))&&y("ZIP_DIRECTORY",r,`header ${l} of the central directory is malformed`);let p=n.subarray(c+et,c+et+h),m=String.fromCharCode(...p);Fa(i,c,m,r),(!Na.test(m)||m.includes(`
`)||h>200)&&y("ZIP_NAME",r,`an entry is called ${JSON.stringify(m.slice(0,80))}`);let v=m.toLowerCase();a.has(v)&&y("ZIP_DUPLICATE",m,"the name is there twice"),a.add(v),s.push({name:m,size:i.getUint32(c+24,!0),crc:i.getUint32(c+16,!0),header:i.getUint32(c+42,!0),central:n.subarray(c,c+et+h)}),c+=et+h}c!==n.length&&y("ZIP_DIRECTORY",r,"bytes behind the last central header");for(let{name:l,header:h,size:p}of s)h+Dt+l.length+p>t&&y("ZIP_TRUNCATED",l,`${p} bytes reach past the entries`);return s}function Fa(n,e,t,r){let i=l=>n.getUint16(e+l,!0),s=l=>n.getUint32(e+l,!0),a=JSON.stringify(t.slice(0,80));(s(42)===4294967295||s(20)===4294967295||s(24)===4294967295)&&y("ZIP_ZIP64",r,`${a} needs ZIP64`),i(34)&&y("ZIP_ZIP64",r,`${a} is on another disk`),i(8)&1&&y("ZIP_ENCRYPTED",r,`${a} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([l,h])=>i(l)!==h)||s(38))&&y("ZIP_HEADER",r,`${a}: a version, flag, time or attribute is not the fixed one`),i(10)&&y("ZIP_COMPRESSED",r,`${a} is compressed`),s(20)!==s(24)&&y("ZIP_SIZE",r,`${a} has two sizes`)}function za(n,e,t){let r=[...n].sort((a,c)=>a.header-c.header),i=0;r.forEach((a,c)=>{a.end=c+1<r.length?r[c+1].header:e,a.extra=a.end-a.header-Dt-a.name.length-a.size,a.extra<0&&y("ZIP_OVERLAP",a.name,"shares bytes with the next entry"),a.header!==i&&y("ZIP_GAP",t,`bytes ${i} to ${a.header} are no entry's`),i=a.end});let s=r[0];s.name!==ht&&y("ZIP_ORDER",t,`${ht} is not the first entry`),s.size>Ii&&y("MANIFEST_TOO_LARGE",ht,`${s.size} bytes; at most ${Ii}`)}function zi(n,e){let t=Bt(e),{name:r}=n,i=n.name.length;e.length<n.end-n.header&&y("ZIP_TRUNCATED",r,"the file ends within it"),t.getUint32(0,!0)===67324752&&t.getUint16(26,!0)===i&&Mi(e.subarray(4,26),n.central.subarray(6,28))&&Mi(e.subarray(Dt,Dt+i),n.central.subarray(et))||y("ZIP_LOCAL_HEADER",r,"local and central header differ");let a=t.getUint16(28,!0),c=Dt+i;Ca(e.subarray(c,c+a),a,r),(n.header+c+a)%Ni&&y("ZIP_ALIGNMENT",r,`data at byte ${n.header+c+a}, no multiple of ${Ni}`),a!==n.extra&&y(a>n.extra?"ZIP_OVERLAP":"ZIP_GAP",r,"its data does not end where the next entry starts");let l=e.subarray(c+a,c+a+n.size);return La(l)!==n.crc&&y("ZIP_CRC",r,"the bytes do not have the CRC-32 of the header"),l}function Ca(n,e,t){if(e===0)return;e>=4&&n.length===e&&n[0]===82&&n[1]===78&&n[2]+256*n[3]===e-4&&n.subarray(4).every(i=>i===0)||y("ZIP_EXTRA",t,"the extra field is not zero padding")}var Mi=(n,e)=>n.length===e.length&&n.every((t,r)=>t===e[r]),Ut=Array.from({length:4},()=>new Uint32Array(256));for(let n=0;n<256;n++){let e=n;for(let t=0;t<8;t++)e=e&1?e>>>1^3988292384:e>>>1;Ut[0][n]=e>>>0}for(let n=1;n<4;n++)for(let e=0;e<256;e++){let t=Ut[n-1][e];Ut[n][e]=t>>>8^Ut[0][t&255]}function La(n){let[e,t,r,i]=Ut,s=4294967295,a=0;for(;a+4<=n.length;a+=4)s^=n[a]|n[a+1]<<8|n[a+2]<<16|n[a+3]<<24,s=i[s&255]^r[s>>>8&255]^t[s>>>16&255]^e[s>>>24];for(;a<n.length;a++)s=e[(s^n[a])&255]^s>>>8;return(s^4294967295)>>>0}var Pa=64,Da=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,Ua=/[ \t\n\r]*/y,Ba=/[^"\\\u0000-\u001f]*/y,Ci={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function pt(n,e,t){let r;try{r=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(n)}catch{y(t,e,"no UTF-8")}let i=new wr(r,e,t);i.space(),r[i.at]!=="{"&&y(t,e,"not a JSON object");let s=i.value(1);return i.space(),i.at!==r.length&&i.bad(),s}var wr=class{constructor(e,t,r){Object.assign(this,{text:e,where:t,code:r,at:0})}bad(e="malformed JSON"){y(this.code,this.where,`${e} at character ${this.at}`)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t&&(this.at=e.lastIndex),t}space(){this.match(Ua)}take(e){return this.text.startsWith(e,this.at)?(this.at+=e.length,!0):!1}value(e){let t=this.text[this.at];if((t==="{"||t==="[")&&e>Pa&&this.bad("nested too deep"),t==="{")return this.object(e);if(t==="[")return this.array(e);if(t==='"')return this.string();for(let[s,a]of[["true",!0],["false",!1],["null",null]])if(this.take(s))return a;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let r=this.match(Da);r||this.bad();let i=Number(r[0]);return Number.isFinite(i)||this.notFinite(),i===0?0:i}notFinite(){y("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(e,t){if(this.at+=1,this.space(),!this.take(e)){do this.space(),t(),this.space();while(this.take(","));this.take(e)||this.bad()}}array(e){let t=[];return this.list("]",()=>t.push(this.value(e+1))),t}object(e){let t=new Map;this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let i=this.string();t.has(i)&&y("JSON_DUPLICATE_KEY",this.where,`the key "${i}" twice`),this.space(),this.take(":")||this.bad(),this.space(),t.set(i,this.value(e+1))});let r=Object.create(null);for(let[i,s]of t)r[i]=s;return r}string(){let e="";for(this.at+=1;e+=this.match(Ba)[0],!this.take('"');){this.take("\\")||this.bad();let t=this.text[this.at++];if(t==="u"){let r=this.match(/[0-9a-fA-F]{4}/y);r||this.bad(),e+=String.fromCharCode(parseInt(r[0],16))}else t in Ci?e+=Ci[t]:this.bad()}return e.isWellFormed()||this.bad("half of a surrogate pair"),e}};var Li={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},$a=65536;function mt(n,e,t,r){let i=e.byteOffset+t;return i%n.BYTES_PER_ELEMENT===0?new n(e.buffer,i,r):new n(e.slice(t,t+r*n.BYTES_PER_ELEMENT).buffer)}function dt(n,e,t){n.length<8&&y(t,e,"shorter than a header");let r=new DataView(n.buffer,n.byteOffset).getBigUint64(0,!0);(r>$a||Number(r)>n.length-8)&&y(t,e,`a header of ${r} bytes`);let i=8+Number(r);n[8]!==123&&y(t,e,"the header does not start with {");let{__metadata__:s,...a}=pt(n.subarray(8,i),e,t);return{tensors:a,metadata:s,data:i}}var Di=n=>n!==null&&typeof n=="object"&&!Array.isArray(n),Pi=n=>Number.isSafeInteger(n)&&n>=0;function gt(n){return Di(n)&&typeof n.dtype=="string"&&Array.isArray(n.shape)&&n.shape.every(Pi)&&Array.isArray(n.data_offsets)&&n.data_offsets.length===2&&n.data_offsets.every(Pi)}var vt=n=>n===void 0||Di(n);function yt(n,{tensors:e,data:t},r,i,s){let a=0,c=r.map(l=>{let{dtype:h,shape:p,data_offsets:[m,v]}=e[l],b=p.reduce((S,T)=>S*T,1);return(m!==a||v-m!==b*Li[h].BYTES_PER_ELEMENT||t+v>n.length)&&y(s,i,`the bytes of ${l} are not where they must be`),a=v,mt(Li[h],n,t+m,b)});return t+a!==n.length&&y(s,i,"bytes behind the last tensor"),c}var Ui=2**26,Ha=2**25,Ga=2**31,qa={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},Za={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function Bi(n,e,t){let r=dt(n,e,"GEOMETRY_CONTAINER"),{tensors:i}=r,s="steps"in i||"scales"in i,a=s?Za:qa,c=Object.keys(a);ja(r,a,c,e),s&&t&&y("VERSION_TOO_OLD",e,"quantised curves in a package for readers of 1.0");let l=Object.fromEntries(c.map(T=>[T,i[T].shape])),h=yt(n,r,c,e,"GEOMETRY_RANGE"),p=Object.fromEntries(c.map((T,L)=>[T,h[L]])),m=l.offsets[0]-1,v=l.radii[0];(!(s?l.origins[0]===m&&l.steps[0]===v-m&&l.scales[0]===2:l.points[0]===v)||m<1)&&y("GEOMETRY_ARRAY",e,"tensors whose shapes do not fit each other"),Wa(p.offsets,v,e);let S=s?Ya(p,e):p;return Va(S,e),S}function ja(n,e,t,r){let{tensors:i}=n,s="GEOMETRY_PROFILE",a=Object.keys(i);(a.length!==t.length||t.some(l=>!a.includes(l)))&&y(s,r,`found ${a.join(", ")||"no tensors"}, expected ${t.join(", ")}`),vt(n.metadata)||y(s,r,"__metadata__ is no object");for(let[l,[h,p]]of Object.entries(e)){let m=i[l];gt(m)&&h.includes(m.dtype)&&m.shape.length===p&&(p===1||m.shape[1]===3)||y(s,r,`${l} is not ${h.join(" or ")} of ${p} dimensions`)}((i.points??i.radii).shape[0]>Ui||i.radii.shape[0]>Ui||i.offsets.shape[0]-1>Ha)&&y(s,r,"more points or strands than allowed"),n.data%64&&y(s,r,"data does not start at a multiple of 64")}function Wa(n,e,t){let r=n[0]===0&&n.at(-1)===e;for(let i=1;i<n.length&&r;i++)r=n[i]>=n[i-1]+2;r||y("GEOMETRY_STRANDS",t,"the offsets do not part the points into strands")}function Ya({scales:n,origins:e,offsets:t,steps:r,radii:i},s){let[a,c]=n;a>0&&Number.isFinite(a)||y("GEOMETRY_STEPS",s,"steps without length"),e.some(p=>!Number.isFinite(p))&&y("GEOMETRY_NOT_FINITE",s,"an origin is not finite"),(!(c>0&&Number.isFinite(c))||i.some(p=>p===0))&&y("GEOMETRY_RADIUS",s,"a radius that is not above 0");let l=new Float32Array(3*i.length),h=0;for(let p=0;p+1<t.length;p++){for(let m=0;m<3;m++){let v=e[3*p+m],b=0;l[3*t[p]+m]=v;for(let S=t[p]+1,T=h;S<t[p+1];S++,T++)b+=r[3*T+m],Math.abs(b)>Ga&&y("GEOMETRY_STEPS",s,`strand ${p} goes too far`),l[3*S+m]=v+a*b}h+=t[p+1]-t[p]-1}return{points:l,radii:Float32Array.from(i,p=>p*c),offsets:t}}function Va({points:n,radii:e,offsets:t},r){(n.some(i=>!Number.isFinite(i))||e.some(i=>!Number.isFinite(i)))&&y("GEOMETRY_NOT_FINITE",r,"a point or a radius is not finite");for(let i=0;i+1<t.length;i++)for(let s=t[i]+1;s<t[i+1];s++)n[3*s]===n[3*s-3]&&n[3*s+1]===n[3*s-2]&&n[3*s+2]===n[3*s-1]&&y("GEOMETRY_SEGMENT",r,`two equal points in strand ${i}`);e.some(i=>!(i>0))&&y("GEOMETRY_RADIUS",r,"a radius that is not above 0")}var Xa={1:Float32Array,2:Uint8Array,3:Int8Array,6:Int32Array},Ka=64*2**20,Ja=4096,Qa=2**18;function Hi(n,e){n.length>Ka&&y("DECODER_TOO_LARGE",e,`${n.length} bytes`);let t=l=>y("DECODER_NOT_ONNX",e,l),r=new _r(t),i=r.message(n,{1:"one",7:"one",8:"many",20:"many",25:"many"});(!i[7]||!i[1])&&t("no graph, or no IR version"),(i[20].length||i[25].length)&&y("DECODER_NESTED",e,"functions or training information"),ec(i,r,e);let s=r.message(i[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});s[15].length&&y("DECODER_NESTED",e,"sparse tensors"),s[1].length>Ja&&y("DECODER_GRAPH",e,`${s[1].length} nodes`);let a=s[1].map(l=>tc(r,l,e)),c=new Map;for(let l of s[5]){let h=Gi(r,l,e);c.has(h.name)&&y("DECODER_GRAPH",e,`${h.name} is there twice`),c.set(h.name,h)}return{nodes:a,constants:c,inputs:s[11].map(l=>$i(r,l)),outputs:s[12].map(l=>$i(r,l))}}function ec(n,e,t){let r=Number(n[1]);r>=7&&r<=10||y("DECODER_VERSION",t,`IR version ${r}`);let i=n[8].map(c=>e.message(c,{1:"one",2:"one"})),s=i.map(c=>e.text(c[1]));s.some(c=>c!==""&&c!=="ai.onnx")&&y("DECODER_DOMAIN",t,`operators of ${s.join(", ")}`);let a=Number(i[0]?.[2]??0);(i.length!==1||a<13||a>21)&&y("DECODER_VERSION",t,`operator set ${a}`)}function tc(n,e,t){let r=n.message(e,{1:"many",2:"many",4:"one",5:"many",7:"one"}),i=n.text(r[7]);i!==""&&i!=="ai.onnx"&&y("DECODER_DOMAIN",t,`an operator of ${i}`);let s={};for(let a of r[5]){let{1:c,3:l,5:h,6:p,11:m}=n.message(a,{1:"one",3:"one",5:"one",6:"one",11:"many"});(p||m.length)&&y("DECODER_NESTED",t,"a graph within a node"),h&&Gi(n,h,t),s[n.text(c)]=l===void 0?null:Number(BigInt.asIntN(64,l))}return{operator:n.text(r[4]),inputs:r[1].map(n.text),outputs:r[2].map(n.text),attributes:s}}function Gi(n,e,t){let r=n.message(e,{1:"numbers",2:"one",8:"one",9:"one",13:"many",14:"one"});(r[13].length||r[14])&&y("DECODER_EXTERNAL",t,"data outside the file");let i=r[1].map(Number),s=Number(r[2]??0);(i.length>2||i.some(h=>h>8192)||![1,2,3,6,7,9,10].includes(s))&&y("DECODER_TENSOR",t,`a tensor of type ${s} and shape [${i}]`);let a=i.reduce((h,p)=>h*p,1),c=Xa[s],l=c&&r[9]instanceof Uint8Array&&r[9].length===a*c.BYTES_PER_ELEMENT;return{name:n.text(r[8]),type:s,dims:i,values:l?mt(c,r[9],0,a):null}}function $i(n,e){let t=n.message(e,{1:"one",2:"one"}),r=n.message(t[2]??new Uint8Array,{1:"one"}),i=n.message(r[1]??new Uint8Array,{1:"one",2:"one"}),a=n.message(i[2]??new Uint8Array,{1:"many"})[1].map(c=>{let{1:l,2:h}=n.message(c,{1:"one",2:"one"});return h!==void 0&&n.text(h),l===void 0?null:Number(l)});return{name:n.text(t[1]),type:Number(i[1]??0),dims:a}}var _r=class{constructor(e){this.wrong=e,this.fields=0,this.text=(t=new Uint8Array)=>{if(!(t instanceof Uint8Array))return e("a name that is no text");try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{return e("a name that is no UTF-8")}}}message(e,t){e instanceof Uint8Array||this.wrong("a message that is a number");let r={};for(let[i,s]of Object.entries(t))s!=="one"&&(r[i]=[]);for(let i=0;i<e.length;){++this.fields>Qa&&this.wrong("too many fields");let s,a;[s,i]=this.varint(e,i),[a,i]=this.value(e,i,Number(s&7n)),this.keep(r,Number(s>>3n),a,t)}return r}keep(e,t,r,i){let s=i[t];if(s==="many")e[t].push(r);else if(s==="one")e[t]!==void 0&&this.wrong(`the field ${t} twice`),e[t]=r;else if(s==="numbers"&&r instanceof Uint8Array)for(let a=0,c;a<r.length;)[c,a]=this.varint(r,a),e[t].push(c);else s==="numbers"&&e[t].push(r)}value(e,t,r){if(r===0)return this.varint(e,t);let i={1:8,5:4}[r];return r===2&&([i,t]=this.varint(e,t),i=Number(i)),(i===void 0||t+i>e.length)&&this.wrong("a field that is cut short"),[e.subarray(t,t+i),t+i]}varint(e,t){let r=0n;for(let i=0n;i<70n&&!(t>=e.length);i+=7n){let s=e[t++];if(r|=BigInt(s&127)<<i,s<128)return[BigInt.asUintN(64,r),t]}return this.wrong("a number that is cut short")}};var De=1,nc=2,rc=3,ic=6,qi=2**24,Zi=2**16,ji=2**24;function Wi(n,{columns:e,outputs:t,output:r,precision:i},s){let a=Hi(n,s);sc(a,e,t,r,s);let c=a.nodes.some(({operator:l})=>/^(De)?[qQ]uantizeLinear$/.test(l));return c!==(i==="int8")&&y("DECODER_PRECISION",s,`arithmetic that is not ${i}`),ac(a,s),new xr(a,e,t,c,s).decoder()}function sc({inputs:n,outputs:e},t,r,i,s){let a=(c,l,h)=>c.length===1&&c[0].name===l&&c[0].type===De&&c[0].dims.length===2&&c[0].dims[0]===null&&c[0].dims[1]===h;a(n,"queries",t)||y("DECODER_INPUT",s,`not one input queries [N, ${t}]`),a(e,i,r)||y("DECODER_OUTPUT",s,`not one output ${i} [N, ${r}]`)}var oc=new Set(`Abs Add And Atan Cast Ceil Clip Concat Constant Cos DequantizeLinear Div Elu Equal Erf Exp
Floor Gelu Gemm Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN LayerNormalization LeakyRelu Less
LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu Pow QuantizeLinear Reciprocal Relu Selu Sigmoid Sign Sin Slice
Softplus Softsign Split Sqrt Sub Sum Tanh ThresholdedRelu Where Xor`.split(/\s+/));function ac({nodes:n,constants:e},t){let r=n.find(({operator:s})=>!oc.has(s));r&&y("DECODER_OPERATOR",t,`the operator ${r.operator}`);let i=new Set(["queries",...e.keys()]);for(let s of n)(s.inputs.some(a=>a&&!i.has(a))||s.outputs.some(a=>i.has(a)))&&y("DECODER_GRAPH",t,"nodes out of order, or a value made twice"),s.outputs.forEach(a=>i.add(a))}var xr=class{constructor({nodes:e,constants:t},r,i,s,a){Object.assign(this,{constants:t,columns:r,outputs:i,int8:s,where:a,width:r,at:0,value:"queries"});let c=({operator:p,inputs:m})=>p==="DequantizeLinear"&&t.has(m[0]);this.dequantizers=new Map(e.filter(c).map(p=>[p.outputs[0],p])),this.chain=e.filter(p=>!c(p)),this.values=this.work=0;let h=[...t.values(),...[...this.dequantizers.values()].map(({inputs:p})=>t.get(p[0]))].reduce((p,{dims:m})=>p+m.reduce((v,b)=>v*b,1),0);h>qi&&y("DECODER_COST",a,`${h} values of constants; at most ${qi}`),this.readers=new Map;for(let p of e.flatMap(m=>m.inputs))this.readers.set(p,(this.readers.get(p)??0)+1)}outside(e){throw new B(`${this.where}: this viewer runs decoders of the profile (spec, 6.4) alone: ${e} [DECODER_PROFILE]`)}get operator(){return this.chain[this.at]?.operator}next(e){let t=this.chain[this.at];return(t?.operator!==e||t.inputs[0]!==this.value||t.outputs.length!==1)&&this.outside(`${t?.operator??"nothing"} where ${e} must be`),(this.readers.get(this.value)!==1||Object.keys(t.attributes).length)&&this.outside(`${e} with attributes, or a value that is read twice`),this.at+=1,this.value=t.outputs[0],t.inputs.slice(1)}spend(e,t=1){this.values+=e,this.work+=t*e,(this.values>Zi||this.work>ji)&&y("DECODER_COST",this.where,`a query takes ${this.values} values and ${this.work} multiply-adds, or more; at most ${Zi} and ${ji}`)}constant(e,t,r){let i=this.constants.get(e);return(!i?.values||i.type!==t||i.dims.join()!==r.join())&&this.outside(`${e??"nothing"} is not of type ${t} and shape [${r}]`),i.values}take(e,...t){let r=this.next(e);return e==="MatMul"?this.spend(this.outputs,this.width):this.spend(this.width),r.length!==t.length&&this.outside(`${e} of ${r.length+1} operands`),t.map(([i,s],a)=>this.constant(r[a],i,s))}decoder(){let e=[De,[]],t=[De,[this.columns]],[[r],[i]]=this.take("Clip",e,e),s=this.int8?this.take("Mul",t)[0]:null,a=this.int8?this.take("Add",t)[0]:null,c=this.layers(),[[l],[h]]=this.take("Clip",e,e);this.take("Exp");let[[p]]=this.take("Sub",e);(l!==0||p!==1)&&this.outside(`Clip from ${l}, Sub of ${p}`);let[m]=this.operator==="MatMul"?this.take("MatMul",[De,[this.width,this.outputs]]):this.take("Mul",e);(this.operator||this.dequantizers.size)&&this.outside("nodes behind the last one"),m.length===1&&this.width!==this.outputs&&y("DECODER_LOAD",this.where,`${this.width} values for ${this.outputs} outputs`);let v=m.length===1?{unit:m[0],matrix:null}:{unit:1,matrix:m};return{low:r,high:i,gain:s,offset:a,layers:c,top:h,...v,int8:this.int8,columns:this.columns,outputs:this.outputs}}layers(){let e=[];for(;;){let t=this.int8?this.quantized():null;if(e.push(this.gemm(t)),this.operator==="Clip")return e;this.int8||this.take("Relu")}}quantized(){let e=[[De,[]],[nc,[]]],[[t],[r]]=this.take("QuantizeLinear",...e),[[i],[s]]=this.take("DequantizeLinear",...e);return(r||s||t!==i)&&this.outside("two scales, or a zero point"),t}gemm(e){let t=this.next("Gemm");t.length!==2&&this.outside(`Gemm of ${t.length+1} operands`);let r=v=>this.constants.get(v)?.dims.at(-1)??0,i=this.width;if(!this.int8){let v=r(t[0]);return this.spend(v,i),this.width=v,{weight:this.fitting(t[0],De,i,v),bias:this.constant(t[1],De,[v]),rows:i,columns:v}}let[s,a]=this.dequantized(t[0],1),[c,l]=this.dequantized(t[1],0),h=r(s);this.spend(h,i);let p=this.constant(a,De,[h]);return this.constant(l,De,[h]).some((v,b)=>v!==Math.fround(e*p[b]))&&this.outside("a bias with a scale of its own"),this.width=h,{weight:this.fitting(s,rc,i,h),bias:this.constant(c,ic,[h]),rows:i,columns:h,step:e,scales:p}}fitting(e,t,r,i){let s=this.constants.get(e)?.dims??[];return s.length===2&&s[0]!==r&&y("DECODER_LOAD",this.where,`weights for ${s[0]} values, of which there are ${r}`),this.constant(e,t,[r,i])}dequantized(e,t){let r=this.dequantizers.get(e);return this.dequantizers.delete(e),(r?.attributes.axis!==t||r.inputs.length!==2||this.readers.get(e)!==1)&&this.outside(`${e} is no DequantizeLinear of constants along axis ${t}`),r.inputs}};async function Yi(n,{elementSize:e,distance:t,size:r},i){let s=await cc(n,r,i),a=Math.floor(r/e),c=new Uint8Array(r);for(let l=0;l<e;l++){let h=l*a;for(let p=0;p<a;p++)c[p*e+l]=s[h+p]}if(c.set(s.subarray(a*e),a*e),t){let l={1:Uint8Array,2:Uint16Array,4:Uint32Array}[e],h=new l(c.buffer,0,a);for(let p=t;p<a;p++)h[p]+=h[p-t]}return c}async function cc(n,e,t){let r=new Uint8Array(e),i=0;try{let s=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:a,value:c}=await s.read();if(a)break;if(i+c.length>e)throw s.cancel().catch(()=>{}),new RangeError(`more than ${e} bytes`);r.set(c,i),i+=c.length}}catch(s){y("DEFLATE_STREAM",t,`no whole zlib stream of ${e} bytes (${s.message})`)}return i!==e&&y("DEFLATE_STREAM",t,`inflates to ${i} bytes, expected ${e}`),r}var Vi={$schema:"https://json-schema.org/draft/2020-12/schema",title:"RNA 1.1 manifest.json",type:"object",if:{required:["parts"]},then:{$ref:"#/$defs/Manifest"},else:{$ref:"#/$defs/ShortManifest"},$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"Cost of a query.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder per query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds per query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Trained directions, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},Manifest:{additionalProperties:!1,description:"manifest.json. `write_package` computes `entries` and the versions; leave them out.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","parts","tiers"],title:"Manifest",type:"object"},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Origin of the asset.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},ShortManifest:{additionalProperties:!1,description:"manifest.json of one part that has nothing new since 1.0.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},tiers:{items:{$ref:"#/$defs/ShortTier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","kind","bounds","geometry","tiers"],title:"ShortManifest",type:"object"},ShortTier:{additionalProperties:!1,description:"A tier of one part, planes and decoder in it.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision","name"],title:"ShortTier",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"Emission of a part: a separate decoder on features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierPart:{additionalProperties:!1,description:"Planes and decoders of one part: of transport, and optionally of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}}};var br={object:n=>n!==null&&typeof n=="object"&&!Array.isArray(n),array:Array.isArray,string:n=>typeof n=="string",number:n=>typeof n=="number",integer:n=>Number.isSafeInteger(n),boolean:n=>typeof n=="boolean",null:n=>n===null};function wt(n,e,t=""){new Er(n).check(n,e,t)}var Er=class{constructor(e){this.root=e}fits(e,t){try{return this.check(e,t,""),!0}catch{return!1}}check(e,t,r){e.$ref&&this.check(this.root.$defs[e.$ref.split("/").pop()],t,r),e.if&&this.check(this.fits(e.if,t)?e.then:e.else,t,r);let i=s=>y("FIELD_VALUE",r,`found ${Ar(t)}, expected ${s}`);e.type&&!br[e.type](t)&&i(e.type),"const"in e&&t!==e.const&&i(Ar(e.const)),e.enum&&!e.enum.includes(t)&&(e.enum.includes("features")&&y("INPUT_UNKNOWN",r,`no block ${Ar(t)}`),i(e.enum.join(", ")));for(let s of[e.anyOf,e.oneOf])s&&!s.some(a=>this.fits(a,t))&&this.check(s.find(a=>br[a.type]?.(t))??s[0],t,r);e.not&&this.fits(e.not,t)&&i("another value"),typeof t=="number"&&this.checkNumber(e,t,i),typeof t=="string"&&this.checkString(e,t,i),Array.isArray(t)?this.checkArray(e,t,r,i):br.object(t)&&this.checkObject(e,t,r)}checkNumber(e,t,r){t<e.minimum&&r(`at least ${e.minimum}`),t>e.maximum&&r(`at most ${e.maximum}`),t<=e.exclusiveMinimum&&r(`more than ${e.exclusiveMinimum}`),t>=e.exclusiveMaximum&&r(`less than ${e.exclusiveMaximum}`)}checkString(e,t,r){t.length<e.minLength&&r(`${e.minLength} characters or more`),t.length>e.maxLength&&r(`at most ${e.maxLength} characters`),e.pattern&&!new RegExp(e.pattern,"u").test(t)&&r(e.pattern)}checkArray(e,t,r,i){t.length<e.minItems&&i(`${e.minItems} items or more`),t.length>e.maxItems&&i(`at most ${e.maxItems} items`),t.forEach((s,a)=>{let c=e.prefixItems?.[a]??e.items;c&&this.check(c,s,`${r}/${a}`)}),e.uniqueItems&&new Set(t).size!==t.length&&y("INPUT_UNKNOWN",r,"a name twice")}checkObject(e,t,r){let i=Object.keys(t),s=e.properties??{};for(let a of i)e.additionalProperties===!1&&!Object.hasOwn(s,a)&&y("FIELD_UNKNOWN",`${r}/${a}`,"no such member"),e.propertyNames&&this.check({type:"string",...e.propertyNames},a,`${r}/${a}`);for(let a of e.required??[])Object.hasOwn(t,a)||y("FIELD_MISSING",`${r}/${a}`,"missing");for(let a of i){let c=Object.hasOwn(s,a)?s[a]:e.additionalProperties;c&&this.check(c,t[a],`${r}/${a}`)}}};function Ar(n){let e=JSON.stringify(n);return e.length>60?`${e.slice(0,57)}...`:e}var Rr={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},$t=(n,e=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:n,maximum:e}),kr={type:"number",minimum:0,maximum:1},tt=n=>({type:"object",properties:n,required:Object.keys(n),additionalProperties:!1}),Ki=2**32-2,uc=2**20,fc=64,Ji={RNA_deflate:tt({entries:{type:"object",propertyNames:Rr,additionalProperties:tt({elementSize:{enum:[1,2,4]},distance:$t(0),size:$t(0,Ki),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:tt({image:Rr,width:$t(1),height:$t(1)}),RNA_standin:tt({parts:{type:"array",minItems:1,maxItems:16,items:tt({baseColor:{type:"array",items:kr,minItems:3,maxItems:3},roughness:kr,metallic:kr})}}),RNA_proxy:tt({parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"array",minItems:1,maxItems:8,items:tt({geometry:Rr,height:$t(1)})}]}}})},En=Object.keys(Ji);function Qi(n){let e=n.extensions??{};for(let t of En){let r=`/extensions/${t}`;if(!Object.hasOwn(e,t)){n.extensionsUsed?.includes(t)&&y("FIELD_MISSING",r,"its data is missing");continue}wt(Ji[t],e[t],r),hc[t](e[t],n,r)}}function Sr(n,e,t){Object.hasOwn(n.entries,e)||y("REFERENCE_MISSING",t,`no entry ${e}`)}function Xi(n,e,t){n.length!==e.parts.length&&y("PARTS_DIFFER",t,`found ${n.length} parts, expected ${e.parts.length}`)}var hc={RNA_deflate({entries:n},e,t){e.extensionsRequired?.includes("RNA_deflate")||y("EXTENSION_UNDECLARED",t,"RNA_deflate is not in extensionsRequired");let r=Object.values(n).reduce((i,{size:s})=>i+s,0);r>Ki&&y("FIELD_VALUE",t,`${r} decoded bytes`);for(let[i,{size:s}]of Object.entries(n)){Sr(e,i,t);let a=uc+fc*e.entries[i].size;s>a&&y("DEFLATE_SIZE",`${t}/entries/${i}/size`,`${s} decoded bytes; at most ${a}`)}},RNA_poster({image:n},e,t){Sr(e,n,t)},RNA_standin({parts:n},e,t){Xi(n,e,t)},RNA_proxy({parts:n},e,t){Xi(n,e,t),n.some(r=>r)||y("FIELD_VALUE",t,"a proxy of no part"),n.forEach((r,i)=>{let{transmittance:s,normalMaps:a}=e.parts[i];r&&(s||a)&&y("FIELD_VALUE",t,"a proxy of a part with textures"),(r??[]).forEach(({geometry:c,height:l},h)=>{Sr(e,c,t),h&&l>=r[h-1].height&&y("FIELD_VALUE",t,"heights must descend")})})}};var es=[1,1],pc=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;function ts(n){let e=pt(n,"manifest.json","MANIFEST_NOT_JSON");mc(e),wt(dc(Vi,e),e);let t=gc(e);vc(t),yc(t),wc(t);let r=rs(ns(t.minReaderVersion),es)<0;e.parts&&r&&y("VERSION_TOO_OLD","/minReaderVersion","1.0, with `parts`"),_c(t),Qi(t),xc(t),bc(t),Ec(t);let i=(t.extensionsUsed??[]).filter(s=>!En.includes(s));return{...t,old:r,warnings:i.map(s=>`unknown extension ${s}`)}}var ns=n=>n.split(".").map(Number),rs=(n,e)=>n[0]-e[0]||n[1]-e[1];function mc(n){"format"in n||y("FIELD_MISSING","/format","missing"),n.format!=="rna"&&y("FORMAT_UNKNOWN","/format","this is no RNA package");let e=n.minReaderVersion;typeof e=="string"&&pc.test(e)&&!e.endsWith(`
`)&&rs(ns(e),es)>0&&y("VERSION_TOO_NEW","/minReaderVersion",`the package needs a reader of version ${e}`);let t=Array.isArray(n.parts)?n.parts:[n];for(let r of t)r?.kind!==void 0&&!["surface","fiber"].includes(r.kind)&&y("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(r.kind)}, expected surface or fiber`);for(let r of Array.isArray(n.extensionsRequired)?n.extensionsRequired:[])typeof r=="string"&&!En.includes(r)&&y("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${r}`)}function dc(n,e){let t="parts"in e?"Manifest":"ShortManifest";return{...n.$defs[t],$defs:n.$defs}}function gc(n){if(n.parts)return n;let{kind:e,bounds:t,geometry:r,...i}=n,s=n.tiers.map(({name:a,validation:c,cost:l,...h})=>({name:a,validation:c,cost:l,parts:[h]}));return{...i,parts:[{name:"asset",kind:e,bounds:t,geometry:r}],tiers:s}}function vc(n){n.parts.forEach(({bounds:{min:e,max:t}},r)=>{e.forEach((i,s)=>{Math.fround(t[s])-Math.fround(i)>=1e-18||y("BOUNDS_EMPTY",`/parts/${r}/bounds`,`no extent along axis ${s}`)})});for(let e of["wo","wi"]){let t=n.domain[e];for(let{axis:r}of Array.isArray(t)?t:[])Math.abs(Math.hypot(...r)-1)>.001&&y("FIELD_VALUE",`/domain/${e}`,"an axis is no unit vector")}}function yc(n){for(let[e,t]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let r=n[e].map(({name:i})=>i);new Set(r).size!==r.length&&y(t,`/${e}`,"a name is there twice")}n.tiers.forEach(({validation:e},t)=>{(e?.flipAtHeight??[]).forEach(({height:r},i,s)=>{i&&r>=s[i-1].height&&y("FIELD_VALUE",`/tiers/${t}/validation/flipAtHeight/${i}`,"heights must descend")})})}function wc(n){n.tiers.forEach((e,t)=>{e.parts.length!==n.parts.length&&y("PARTS_DIFFER",`/tiers/${t}/parts`,`found ${e.parts.length}, expected ${n.parts.length}`),e.parts.forEach((r,i)=>{!r.emission!=!n.tiers[0].parts[i].emission&&y("PARTS_DIFFER",`/tiers/${t}/parts/${i}`,"emission in some tiers alone")})})}function _c(n){let e=n.extensionsUsed??[];for(let t of[...Object.keys(n.extensions??{}),...n.extensionsRequired??[]])e.includes(t)||y("EXTENSION_UNDECLARED","/extensionsUsed",`${t} is not there`)}function xc(n){n.tiers.forEach((e,t)=>e.parts.forEach((r,i)=>{let{kind:s}=n.parts[i],a=(c,l)=>{for(let h of c)l(Pt(h))||y("INPUT_KIND",`/tiers/${t}/parts/${i}/inputs`,`${h} is not for this part`)};a(r.inputs,({kinds:c})=>c.includes(s)),a(r.emission?.inputs??[],({kinds:c,light:l})=>c.includes(s)&&!l)}))}function bc(n){n.parts.forEach((e,t)=>{for(let[r,i]of[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"]]){let s=`/parts/${t}/${r}`;e[r]&&e.kind!=="surface"&&y("FIELD_VALUE",s,`of a ${e.kind}`);let a=0;(e[r]??[]).forEach(({triangles:[c,l]},h)=>{c<a&&y(i,`${s}/${h}`,"ranges must ascend and not overlap"),a=c+l})}})}function*Ac(n){for(let[e,t]of n.parts.entries()){yield[`/parts/${e}/geometry`,t.geometry];for(let r of["transmittance","normalMaps"])for(let[i,s]of(t[r]??[]).entries())yield[`/parts/${e}/${r}/${i}`,s.texture]}for(let[e,t]of n.tiers.entries())for(let[r,i]of t.parts.entries()){let s=`/tiers/${e}/parts/${r}`;yield[`${s}/planes`,i.planes],yield[`${s}/decoder`,i.decoder],i.emission&&(yield[`${s}/emission/decoder`,i.emission.decoder])}}function Ec(n){let e=new Set;for(let[r,i]of Ac(n))Object.hasOwn(n.entries,i)||y("REFERENCE_MISSING",r,`no entry ${i}`),e.add(i);let t=(n.extensionsUsed??[]).map(r=>`extensions/${r}/`);for(let r of Object.keys(n.entries))!e.has(r)&&!t.some(i=>r.startsWith(i))&&y("ENTRY_UNREFERENCED","/entries",`nothing refers to ${r}`)}function is(n,e){for(let t of e.keys())t!=="manifest.json"&&!Object.hasOwn(n.entries,t)&&y("ENTRY_UNDECLARED","/entries",`the archive holds ${t}`);for(let[t,{size:r}]of Object.entries(n.entries)){let i=e.get(t);(!i||t==="manifest.json")&&y("ENTRY_MISSING","/entries",`the archive lacks ${t}`),i.size!==r&&y("ENTRY_SIZE",`/entries/${t}`,`found ${i.size}, expected ${r}`)}}var je={type:"string"},ss={type:"array",items:{type:"number"}},Oe=n=>({type:"integer",minimum:n,maximum:2**32-1}),We=n=>({type:"array",minItems:1,maxItems:1,items:n}),Ie=(n,e={})=>({type:"object",properties:{...n,...e},required:Object.keys(n),additionalProperties:!1}),os={type:"array",minItems:3,maxItems:3,items:{type:"number"}},as={const:"KHR_mesh_quantization"};function cs(n){let e=n?[5122,5123,5125,5126]:[5125,5126],t=Ie({bufferView:Oe(0),componentType:{enum:e},count:Oe(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:Oe(0),normalized:n?{type:"boolean"}:{const:!1},min:ss,max:ss,name:je}),r=Ie({buffer:{const:0},byteLength:Oe(1)},{byteOffset:Oe(0),target:{enum:[34962,34963]},name:je,...n&&{byteStride:{enum:[4,8]}}}),i=Ie({POSITION:Oe(0),NORMAL:Oe(0)},{TEXCOORD_0:Oe(0)}),s=Ie({attributes:i,indices:Oe(0)},{mode:{const:4}});return Ie({asset:Ie({version:{const:"2.0"}},{generator:je,copyright:je}),scenes:We(Ie({nodes:We({const:0})},{name:je})),nodes:We(Ie({mesh:{const:0},...n&&{translation:os,scale:os}},{name:je})),meshes:We(Ie({primitives:We(s)},{name:je})),buffers:We(Ie({byteLength:Oe(1)},{name:je})),accessors:{type:"array",minItems:3,maxItems:4,items:t},bufferViews:{type:"array",minItems:1,maxItems:4,items:r},...n&&{extensionsUsed:We(as),extensionsRequired:We(as)}},{scene:{const:0},extras:{}})}var Rc=cs(!1),kc=cs(!0);function ls(n,e){let t="extensionsUsed"in n||"extensionsRequired"in n;try{wt(t?kc:Rc,n)}catch(r){y("GEOMETRY_PROFILE",e,`${r.where}: not as meshes of packages are`)}return t&&Sc(n.nodes[0],e),Tc(n,t,e),t}function Sc({scale:[n,e,t]},r){n>0&&n===e&&n===t||y("GEOMETRY_PROFILE",r,`the scale ${[n,e,t]}`)}function Tc(n,e,t){let{attributes:r,indices:i}=n.meshes[0].primitives[0],s=e?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[c,l]of[...Object.entries(r),["indices",i]]){let h=n.accessors[l],p=h&&n.bufferViews[h.bufferView];if(!p)continue;let[m,v]=s[c];m.includes(h.type)&&v.some(([S,T,L])=>h.componentType===S&&(h.normalized??!1)===T&&p.byteStride===L)||y("GEOMETRY_PROFILE",t,`the accessor of ${c}`)}n.accessors[i]?.componentType===5123&&n.accessors[r.POSITION]?.count>=65535&&y("GEOMETRY_PROFILE",t,"indices of 16 bits for too many vertices")}var Nc={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},Oc={SCALAR:1,VEC2:2,VEC3:3};function us(n,e,t){let{json:r,bin:i}=Ic(n,e),s=ls(r,e);s&&t&&y("VERSION_TOO_OLD",e,"a quantised mesh in a package for readers of 1.0");let a=r.buffers[0].byteLength;(a>i.length||i.length-a>3)&&y("GEOMETRY_RANGE",e,`a buffer of ${a} bytes in a chunk of ${i.length}`);let c=r.meshes[0].primitives[0],l=m=>Mc(r,i.subarray(0,a),m,e),h={positions:l(c.attributes.POSITION),normals:l(c.attributes.NORMAL),uvs:"TEXCOORD_0"in c.attributes?l(c.attributes.TEXCOORD_0):null,indices:l(c.indices)};Fc(h,e),zc(r.accessors[c.attributes.POSITION],h.positions,s,e);let p=s?Cc(h,r.nodes[0]):h;return p.indices=Uint32Array.from(h.indices),Lc(p,e),p}function Ic(n,e){let t="GEOMETRY_CONTAINER",r=new DataView(n.buffer,n.byteOffset,n.length);(n.length<20||r.getUint32(0,!0)!==1179937895||r.getUint32(4,!0)!==2)&&y(t,e,"no binary glTF 2.0"),r.getUint32(8,!0)!==n.length&&y(t,e,"the length in the header is not that of the entry");let i=[];for(let s=12;s<n.length;){s+8>n.length&&y(t,e,"a chunk is cut short");let a=r.getUint32(s,!0),c=r.getUint32(s+4,!0);(a%4||s+8+a>n.length)&&y(t,e,`a chunk of ${a} bytes`),i.push([c,n.subarray(s+8,s+8+a)]),s+=8+a}return i.map(([s])=>s).join()!==[1313821514,5130562].join()&&y(t,e,"not the chunks JSON and BIN"),i[0][1].length>65536&&y(t,e,"JSON of more than 64 KiB"),{json:pt(i[0][1],e,t),bin:i[1][1]}}function Mc(n,e,t,r){let i=n.accessors[t];i||y("GEOMETRY_RANGE",r,`no accessor ${t}`);let s=n.bufferViews[i.bufferView];s||y("GEOMETRY_RANGE",r,`no buffer view ${i.bufferView}`);let a=Nc[i.componentType],c=Oc[i.type],l=a.BYTES_PER_ELEMENT*c,h=s.byteStride??l,p=(s.byteOffset??0)+(i.byteOffset??0),m=(i.byteOffset??0)+h*(i.count-1)+l;(m>s.byteLength||(s.byteOffset??0)+s.byteLength>e.length)&&y("GEOMETRY_RANGE",r,`accessor ${t} reaches past its bytes`),p%4&&y("GEOMETRY_PROFILE",r,`accessor ${t} is not aligned`);let v=h===l?mt(a,e,p,c*i.count):new a(c*i.count);if(h!==l){let b=mt(a,e,p,Math.floor(m-(i.byteOffset??0))/a.BYTES_PER_ELEMENT),S=h/a.BYTES_PER_ELEMENT;for(let T=0;T<i.count;T++)for(let L=0;L<c;L++)v[c*T+L]=b[S*T+L]}return Object.assign(v,{items:c})}function Fc({positions:n,normals:e,uvs:t,indices:r},i){let s=n.length/3;(e.length!==n.length||t&&t.length!==2*s||!s)&&y("GEOMETRY_ARRAY",i,"attributes of different counts"),(r.length%3||!r.length)&&y("GEOMETRY_ARRAY",i,"part of a triangle")}function zc(n,e,t,r){["min","max"].every(s=>{if(n[s]?.length!==3)return!1;for(let a=0;a<3;a++){let c=e[a];for(let h=a;h<e.length;h+=3)(s==="min"?e[h]<c:e[h]>c)&&(c=e[h]);if((t?n[s][a]:Math.fround(n[s][a]))!==c&&Number.isFinite(c))return!1}return!0})||y("GEOMETRY_BOUNDS",r,"min and max of POSITION are not those of its values")}function Cc({positions:n,normals:e,uvs:t},{translation:r,scale:i}){return{positions:Float32Array.from(n,(s,a)=>r[a%3]+i[0]*s),normals:Float32Array.from(e,s=>Math.max(s/32767,-1)),uvs:t&&(t instanceof Uint16Array?Float32Array.from(t,s=>s/65535):t)}}function Lc({positions:n,normals:e,uvs:t,indices:r},i){for(let a of[n,e,t??[]])for(let c=0;c<a.length;c++)Number.isFinite(a[c])||y("GEOMETRY_NOT_FINITE",i,"an attribute is not finite");let s=n.length/3;for(let a=0;a<r.length;a++)r[a]>=s&&y("GEOMETRY_INDEX",i,`vertex ${r[a]} of ${s}`);for(let a=0;a<e.length;a+=3){let c=Math.hypot(e[a],e[a+1],e[a+2]);Math.abs(c-1)>.001&&y("GEOMETRY_NORMAL",i,`a normal of length ${c}`)}}var Pc={float16:"F16",float32:"F32",int8:"I8"},Tr=1e18;function fs(n,{planePrecision:e,resolution:t,channels:r},i){let s=dt(n,i,"PLANES_HEADER"),{tensors:a}=s,c=e==="int8",l=c?{scales:["F32",[3,r]],planes:["I8",[3,t,t,r]]}:{planes:[Pc[e],[3,t,t,r]]},h=Object.keys(l),p=Object.keys(a);vt(s.metadata)||y("PLANES_TENSOR",i,"__metadata__ is no object"),(p.length!==h.length||h.some(S=>!p.includes(S)))&&y("PLANES_TENSOR",i,`found ${p.join(", ")||"no tensors"}, expected ${h.join(", ")}`);for(let S of h)gt(a[S])||y("PLANES_HEADER",i,`${S} is no tensor`);for(let S of h){let[T,L]=l[S],Y=a[S];Y.dtype!==T&&y("PLANES_DTYPE",i,`${S}: found ${Y.dtype}, expected ${T}`),Y.shape.join()!==L.join()&&y("PLANES_SHAPE",i,`${S}: found [${Y.shape}], expected [${L}]`)}let m=yt(n,s,h,i,"PLANES_HEADER");s.data%64&&y("PLANES_ALIGNMENT",i,"data does not start at a multiple of 64");let v=m.at(-1),b=c?m[0]:null;return Dc(e,v,b,i),{values:v,scales:b,resolution:t,channels:r,precision:e}}function Dc(n,e,t,r){let i=()=>y("PLANES_NOT_FINITE",r,`NaN, or a value beyond ${Tr}`);if(n==="int8")t.some(s=>!(Math.abs(s)*128<=Tr))&&i();else if(n==="float16")for(let s=0;s<e.length;s++)(e[s]&31744)===31744&&i();else for(let s=0;s<e.length;s++)Math.abs(e[s])<=Tr||i()}var Uc=8192;function hs(n,e,t,r,i){let s=dt(n,r,i),a=s.tensors[e];vt(s.metadata)||y(i,r,"__metadata__ is no object"),(Object.keys(s.tensors).join()!==e||!gt(a))&&y(i,r,`not one tensor ${e}`);let[c,l,h]=a.shape,p=a.shape.length===3&&[c,l].every(v=>v>=1&&v<=Uc);(a.dtype!=="U8"||!p||!t.includes(h))&&y(i,r,`found ${a.dtype} [${a.shape}], expected U8 [H, W, ${t.join(" or ")}]`),s.data%64&&y(i,r,"data does not start at a multiple of 64");let[m]=yt(n,s,[e],r,i);return{values:m,height:c,width:l,channels:h}}function ps(n,e,t){let r="TRANSMITTANCE_TEXTURE",i=hs(n,"transmittance",[1,3],t,r);return e.cutoff!==void 0&&i.channels!==1&&y(r,t,"a cutoff of a coloured texture"),i}function ms(n,e){return hs(n,"normals",[2],e,"NORMAL_MAP_TEXTURE")}function Nr({triangles:[n,e]},t,r,i,s){n+e>r.indices.length/3&&y(`${s}_RANGE`,i,`triangles ${n} to ${n+e} of ${r.indices.length/3}`),(s==="NORMAL_MAP"||t.width*t.height>1)&&!r.uvs&&y(`${s}_UV`,i,"the mesh has no texture coordinates")}var Bc=65536,_t=class n{static async open(e){let t=new n;return t.source=e,t.directory=await Fi(e),t.cache=new Map,t.manifest=ts(await t._stored(ht)),is(t.manifest,t.directory),t}get poster(){return this.manifest.extensions?.RNA_poster}tier(e){let t=e?this.manifest.tiers.find(r=>r.name===e):this.manifest.tiers[0];if(!t){let r=this.manifest.tiers.map(i=>i.name).join(", ");y("TIER_UNKNOWN",this.source.name,`no tier ${e}; there are ${r}`)}return t}bytesOf(e){return this._ranges(this._entriesOf(this.tier(e))).reduce((t,[r,i])=>t+i-r,0)}async load(e){let t=this.tier(e),r=this._entriesOf(t);await this._fetch(r);let i=new Map;for(let a of r)i.set(a,await this._data(a));let s=this.manifest.parts.map((a,c)=>this._part(a,t.parts[c],c,i));return{name:t.name,tier:t,parts:s}}async posterImage(){return this.poster?(await this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear()}_part(e,t,r,i){let{kind:s,bounds:a,geometry:c}=e,l=this.manifest.old,h=`/parts/${r}`,p=i.get(c),m={name:e.name,kind:s,bounds:$c(a),inputs:t.inputs};return s==="surface"?m.mesh=us(p,c,l):m.curves=Bi(p,c,l),m.transmittance=(e.transmittance??[]).map(v=>{let b=ps(i.get(v.texture),v,v.texture);return Nr(v,b,m.mesh,h,"TRANSMITTANCE"),{...v,texture:b}}),m.normalMaps=(e.normalMaps??[]).map(v=>{let b=ms(i.get(v.texture),v.texture);return Nr(v,b,m.mesh,h,"NORMAL_MAP"),{...v,texture:b}}),m.planes=fs(i.get(t.planes),t,t.planes),m.transport=ds(i,t,t,"transport",6),m.emission=t.emission?{inputs:t.emission.inputs,...ds(i,t,t.emission,"emission",3)}:null,m}_entriesOf(e){let t=[];for(let r of this.manifest.parts){t.push(r.geometry);for(let i of[...r.transmittance??[],...r.normalMaps??[]])t.push(i.texture)}for(let r of e.parts)t.push(r.planes,r.decoder),r.emission&&t.push(r.emission.decoder);return[...new Set(t)]}_ranges(e){let t=e.map(i=>this.directory.get(i)).sort((i,s)=>i.header-s.header),r=[];for(let{header:i,end:s}of t){let a=r.at(-1);a&&i-a[1]<=Bc?a[1]=s:r.push([i,s])}return r}async _fetch(e){let t=e.filter(r=>!this.cache.has(r));this.source.expected=this.source.ranged?this.source.fetched+this._ranges(t).reduce((r,[i,s])=>r+s-i,0):this.source.size;for(let[r,i]of this._ranges(t)){let s=await this.source.read(r,i);for(let a of t){let c=this.directory.get(a);c.header>=r&&c.end<=i&&this.cache.set(a,s.subarray(c.header-r,c.end-r))}}}async _stored(e){let t=this.directory.get(e),r=this.cache.get(e)??await this.source.read(t.header,t.end);return zi(t,r)}async _data(e){let t=await this._stored(e);await gs(t,this.manifest.entries[e].sha256,e);let r=this.manifest.extensions?.RNA_deflate?.entries[e];if(!r)return t;let i=await Yi(t,r,e);return await gs(i,r.sha256,e),i}};function ds(n,e,t,r,i){let a={columns:t.inputs.reduce((c,l)=>c+An(l,e.channels),0),outputs:i,output:r,precision:t.decoderPrecision};return Wi(n.get(t.decoder),a,t.decoder)}function $c({min:n,max:e}){return{min:n.map(Math.fround),max:e.map(Math.fround)}}async function gs(n,e,t){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",n))].map(s=>s.toString(16).padStart(2,"0")).join("")!==e&&y("ENTRY_HASH",t,"the bytes do not have the declared SHA-256")}var Ht={};gi(Ht,{evaluate:()=>qc,mappedNormals:()=>jc,visibility:()=>Zc});function Rn(n,e,t,r,i,s){let a=Math.ceil(i/256),c=new Float32Array(4*256*a);for(let l=0;l<i;l++)c.set(t.subarray(s*l+r,s*l+r+4),4*l);n.bindTexture(n.TEXTURE_2D,e.texture),n.texSubImage2D(n.TEXTURE_2D,0,0,0,256,a,n.RGBA,n.FLOAT,c)}function Hc(n){let e=[4,8,12].map(r=>Gc(n.subarray(r,r+3))),t=n.every(Number.isFinite)&&e.every(Boolean);e.forEach((r,i)=>n.set(t?r:[0,0,0],4+4*i)),t||n.set([0,0,0,0],0)}function Gc(n){let e=Math.hypot(...n);return e>0&&Number.isFinite(e)?Array.from(n,t=>t/e):null}function vs(n,e){let t=Math.ceil(e/256);n.resize(256,t),n.span={rows:t,firstRow:0},n.frame={cameraAt:["3fv",[0,0,0]],height:["1i",t],firstRow:["1i",0],sampleNumber:["1ui",0]}}async function qc(n,e,t,r,i=!0){let s=t==="transport"?2:1,a=r.length/16,c=new Float32Array(3*s*a),l=n.bandPixels;for(let h=0;h<a;h+=l){let p=Math.min(l,a-h),{gl:m}=n;vs(n,p);let v=r.slice(16*h,16*(h+p));for(let b=0;b<p;b++)Hc(v.subarray(16*b,16*b+16)),v[16*b+7]=v[16*b+3],v[16*b+3]=e+1,v[16*b+15]=1;if([0,4,8].forEach((b,S)=>Rn(m,n.rows.images[S],v,b,p,16)),Rn(m,n.lit.images[0],v,12,p,16),n._decode(t),await n.done(),!!i)for(let b=0;b<s;b++){let S=n.answers.read(b);for(let T=0;T<p;T++)c.set(S.subarray(4*T,4*T+3),3*(s*(h+T)+b))}}return c}function ys(n,e){let t=new Float32Array(16*e.length);e.forEach(({place:r,b1:i,b2:s,x:a,wi:c,part:l},h)=>{t.set([...a,l+1,0,0,0,i,0,0,0,r,1,1,1,s],16*h),e[h].own=c}),vs(n,e.length),[0,4,8,12].forEach((r,i)=>Rn(n.gl,n.rows.images[i],t,r,e.length,16))}async function Zc(n,e){ys(n,e);let{gl:t}=n,r=n.answers.images[0],i=new Float32Array(4*e.length);return e.forEach((s,a)=>i.set(s.wi,4*a)),Rn(t,r,i,0,e.length,4),n._light({kind:"given",colour:[1,1,1]},r),ws(n.lit.read(1),e.length)}async function jc(n,e){ys(n,e);let[,t,r,i]=n.rows.images;return n._pass("normals",n.answers,{...n.asset,rows1:t,rows2:r,rows3:i},n.geometry),ws(n.answers.read(0),e.length)}function ws(n,e){return Float32Array.from({length:3*e},(t,r)=>n[4*Math.floor(r/3)+r%3])}var Zt={};gi(Zt,{evaluate:()=>Vc,mappedNormals:()=>Kc,visibility:()=>Xc});var Wc=["maxStorageBufferBindingSize","maxBufferSize"];async function _s(){if(!navigator.gpu)throw new B(isSecureContext?"this browser has no WebGPU":"WebGPU needs HTTPS, or a page from this machine");let n=await navigator.gpu.requestAdapter({powerPreference:"high-performance"});if(!n)throw new B("WebGPU has no adapter here");let e=Object.fromEntries(Wc.map(t=>[t,n.limits[t]]));return n.requestDevice({requiredLimits:e})}function ae(n,e,t=GPUBufferUsage.STORAGE,r="a buffer"){let i=typeof e=="number"?e:e.byteLength,s=Math.max(16,Math.ceil(i/16)*16),a=n.limits.maxStorageBufferBindingSize;if(s>a)throw new B(`${r} takes ${qe(s)}; this GPU allows ${qe(a)}`);let c=n.createBuffer({size:s,usage:t|GPUBufferUsage.COPY_DST|GPUBufferUsage.COPY_SRC,mappedAtCreation:typeof e!="number"});if(typeof e!="number"){let l=new Uint8Array(e.buffer,e.byteOffset,e.byteLength);new Uint8Array(c.getMappedRange()).set(l),c.unmap()}return c}async function kn(n,e){let t=n.createShaderModule({code:e}),{messages:r}=await t.getCompilationInfo(),i=r.find(({type:s})=>s==="error");if(i)throw new Error(`a shader does not compile, line ${i.lineNum}: ${i.message}`);return t}var Gt=(n,e,t,r)=>nt(n,e.getBindGroupLayout(t),r);function xt(n,e){let t=Object.entries(e).map(([r,i])=>({binding:Number(r),visibility:GPUShaderStage.COMPUTE,buffer:{type:i}}));return n.createBindGroupLayout({entries:t})}function nt(n,e,t){let r=Object.entries(t).map(([i,s])=>({binding:Number(i),resource:{buffer:s}}));return n.createBindGroup({layout:e,entries:r})}function Me(n,e,t,r){let i=Math.max(1,Math.ceil(r/64)),s=Math.min(i,32768);n.setPipeline(e),t.forEach((a,c)=>n.setBindGroup(c,a)),n.dispatchWorkgroups(s,Math.ceil(i/s))}async function qt(n,e,t){let r=n.createBuffer({size:Math.ceil(t/4)*4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST}),i=n.createCommandEncoder();i.copyBufferToBuffer(e,0,r,0,r.size),n.queue.submit([i.finish()]),await r.mapAsync(GPUMapMode.READ);let s=r.getMappedRange().slice(0);return r.destroy(),s}var Yc={position:[0,0,0],corner:[0,0,0],stepX:[0,0,0],stepY:[0,0,0]};async function Vc(n,e,t,r,i=!0){let s=n.parts[e][t],{device:a,queue:c,bandPixels:l}=n,h=t==="transport"?2:1,p=r.length/16,m=new Float32Array(3*h*p);for(let v=0;v<p;v+=l){let b=Math.min(l,p-v);if(a.queue.writeBuffer(c.rows,0,r,16*v,16*b),a.queue.writeBuffer(c.count,0,Uint32Array.of(b)),n._run(T=>s.run(T,c,b)),await n.done(),!i)continue;let S=new Float32Array(await qt(a,c.answers,16*h*b));for(let T=0;T<h*b;T++)m.set(S.subarray(4*T,4*T+3),3*(h*v+T))}return m}async function xs(n,e,t,r){let{device:i,band:s}=n,{words:a,members:c}=Ee.Pixel,l=new Uint32Array(a*e.length);e.forEach(({place:p,b1:m,b2:v,x:b,wi:S,part:T},L)=>{let Y=(ee,J)=>[...new Uint32Array(Float32Array.from(ee).buffer),J];l.set(fe("Pixel",{position:Y(b,0),axis:[0,0,0,T+1],wo:[0,0,0,p],wi:Y(S,0),b1:m,b2:v}),a*L)}),n.resize(e.length,1),n.span={first:0,pixels:e.length,jitter:0},i.queue.writeBuffer(s,0,l),n._writeFrame(Yc,0),n._writeView({kind:"given",colour:[1,1,1]}),n._run(p=>Me(p,t,n.groups.rays,e.length));let h=new Float32Array(await qt(i,s,l.byteLength));return Float32Array.from({length:3*e.length},(p,m)=>h[a*Math.floor(m/3)+c[r].at+m%3])}var Xc=(n,e)=>xs(n,e,n.kernels.light,"visibility");async function Kc(n,e){let t=await n.pipelines.get(n.raySources.hit,"find_normals",n.rayLayout);return xs(n,e,t,"axis")}var Or=n=>Uint8Array.from(atob(n),e=>e.charCodeAt(0));function Ir(n){let e=new Uint8Array(n.buffer,n.byteOffset,n.byteLength),t="";for(let r=0;r<e.length;r+=8192)t+=String.fromCharCode(...e.subarray(r,r+8192));return btoa(t)}var Sn=class{constructor(e){this.engine=e,this.answers=e.constructor.label==="WebGPU"?Zt:Ht}async load(e,t){let r=await _t.open(new lt(new Blob([Or(e)]),"package"));this.shown=await r.load(t),this.arrays=xn(this.shown.parts),await this.engine.setAsset(this.arrays,this.shown.parts),this.engine.resize(1,1)}async evaluate(e,t,r){let i=t==="transport"?13:10,s=new Float32Array(Or(r).buffer),a=new Float32Array(16*s.length/i);for(let c=0;16*c<a.length;c++){let l=s.subarray(i*c,i*(c+1)),h=l.subarray(7,10);a.set([...l.subarray(0,3),l[6],...l.subarray(3,6),0,...h,0,...i===13?l.subarray(10):h],16*c)}return Ir(await this.answers.evaluate(this.engine,e,t,a))}async visibility(e){return Ir(await this.answers.visibility(this.engine,this._hits(e)))}async normals(e){return Ir(await this.answers.mappedNormals(this.engine,this._hits(e)))}_hits(e){let{buffer:t}=Or(e),r=new Uint32Array(t),i=new Float32Array(t),s=[];for(let a=0;a<r.length;a+=8){let c=r[a+7],{first:l,fiber:h}=this.arrays.parts[c],p=i.subarray(a,a+7),m=this.arrays.where[l+r[a]];s.push(h?{place:m,part:c,b1:0,b2:0,x:p.slice(1,4),wi:p.slice(4,7)}:{place:m,part:c,b1:p[1],b2:p[2],x:[0,0,0],wi:p.slice(3,6)})}return s}};var Jc=`#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;function bs(n){let e=n.getContext("webgl2",{alpha:!1,antialias:!1,preserveDrawingBuffer:!0});if(!e)throw new B("this browser has no WebGL2");if(!e.getExtension("EXT_color_buffer_float"))throw new B("this device's WebGL2 cannot draw into float textures");return e}var bt=class{constructor(e,t){this.gl=e,this.program=e.createProgram();for(let[r,i]of[[e.VERTEX_SHADER,Jc],[e.FRAGMENT_SHADER,`#version 300 es
${t}`]]){let s=e.createShader(r);e.shaderSource(s,i),e.compileShader(s),e.attachShader(this.program,s),e.deleteShader(s)}e.linkProgram(this.program),this.places=new Map}check(){let{gl:e,program:t}=this;if(e.getProgramParameter(t,e.LINK_STATUS)||e.isContextLost())return;let r=e.getAttachedShaders(t).map(i=>e.getShaderInfoLog(i));throw new Error(`a shader does not compile: ${[e.getProgramInfoLog(t),...r].join(" ")}`)}_place(e){return this.places.has(e)||this.places.set(e,this.gl.getUniformLocation(this.program,e)),this.places.get(e)}set(e){for(let[t,[r,...i]]of Object.entries(e))this.gl[`uniform${r}`](this._place(t),...i)}textures(e){Object.entries(e).forEach(([t,r],i)=>{this.gl.activeTexture(this.gl.TEXTURE0+i),this.gl.bindTexture(r.target,r.texture),this.gl.uniform1i(this._place(t),i)})}delete(){this.gl.deleteProgram(this.program)}},Qc=2048;function Fe(n,e,t=Qc){let r=new Map([[Float32Array,[n.RGBA32F,n.RGBA,n.FLOAT]],[Uint32Array,[n.RGBA32UI,n.RGBA_INTEGER,n.UNSIGNED_INT]],[Uint8Array,[n.RGBA8UI,n.RGBA_INTEGER,n.UNSIGNED_BYTE]]]),i=Math.ceil(Math.max(1,e.length/4)/t);el(n,i);let s=new e.constructor(4*t*i);return s.set(e),As(n,t,i,...r.get(e.constructor),s)}function el(n,e){let t=n.getParameter(n.MAX_TEXTURE_SIZE);if(e>t)throw new B(`the asset needs textures of side ${e}; this device has ${t}`)}function As(n,e,t,r,i,s,a=null){let c=n.createTexture();return n.bindTexture(n.TEXTURE_2D,c),n.pixelStorei(n.UNPACK_ALIGNMENT,1),n.texImage2D(n.TEXTURE_2D,0,r,e,t,0,i,s,a),Mr(n,n.TEXTURE_2D),{target:n.TEXTURE_2D,texture:c,width:e,height:t}}function Mr(n,e){n.texParameteri(e,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(e,n.TEXTURE_MAG_FILTER,n.NEAREST),n.texParameteri(e,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(e,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}var Ye=class{constructor(e,t,r,i){if(Object.assign(this,{gl:e,width:t,height:r}),this.images=Array.from({length:i},()=>As(e,t,r,e.RGBA32F,e.RGBA,e.FLOAT)),this.frame=e.createFramebuffer(),e.bindFramebuffer(e.FRAMEBUFFER,this.frame),this.images.forEach(({texture:s},a)=>e.framebufferTexture2D(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+a,e.TEXTURE_2D,s,0)),e.drawBuffers(this.images.map((s,a)=>e.COLOR_ATTACHMENT0+a)),e.checkFramebufferStatus(e.FRAMEBUFFER)!==e.FRAMEBUFFER_COMPLETE&&!e.isContextLost())throw new B("this device cannot draw into float textures")}read(e){let{gl:t,width:r,height:i}=this,s=new Float32Array(4*r*i);return t.bindFramebuffer(t.FRAMEBUFFER,this.frame),t.readBuffer(t.COLOR_ATTACHMENT0+e),t.readPixels(0,0,r,i,t.RGBA,t.FLOAT,s),s}delete(){this.gl.deleteFramebuffer(this.frame);for(let{texture:e}of this.images)this.gl.deleteTexture(e)}};function Tn(n,e,t,{textures:r={},uniforms:i={},to:s}={}){let{width:a,height:c}=t??n.canvas;n.bindFramebuffer(n.FRAMEBUFFER,t?.frame??null),n.viewport(0,0,a,c),n.enable(n.SCISSOR_TEST),n.scissor(0,0,a,s??c),n.useProgram(e.program),e.set(i),e.textures(r),n.drawArrays(n.TRIANGLES,0,3)}async function Es(n){let e=n.fenceSync(n.SYNC_GPU_COMMANDS_COMPLETE,0);for(n.flush();;){if(n.isContextLost())return;let t=n.clientWaitSync(e,0,0);if(t===n.ALREADY_SIGNALED||t===n.CONDITION_SATISFIED)break;await new Promise(r=>setTimeout(r,1))}n.deleteSync(e)}var{RNA_NONE:Ns,MAX_LAYERS:Rs,MAX_EXACT_INPUTS:ks,RNA_CHANNEL_GROUPS:Ss}=ie,jt=n=>Math.ceil(n/4);function On(n,e,t){tl(e);let{places:r,slots:i,queryGroups:s}=nl(t,n.planes.channels),a=new Fr,c=Ns;e.int8&&(c=a.add(Nn(e.gain,r,s)),a.add(Nn(e.offset,r,s)));let l=e.layers.map((b,S)=>{let T=+(!e.int8&&S+1<e.layers.length);return Ts(a,{...b,relu:T},S?null:r,S?0:s)}),h=null;if(e.matrix){let b=e.matrix.length/e.outputs,S=new Float32Array(e.outputs);h=Ts(a,{weight:e.matrix,bias:S,rows:b,columns:e.outputs,relu:0},null,0)}let p=[...l,...h?[h]:[]],m=Math.max(...p.flatMap(({inputs:b,outputs:S})=>[b,S])),v=rl(n,e,{queryGroups:s,gain:c,slots:i,layers:l,matrix:h});return{weights:a.all(),record:v,groups:Math.max(4,2**Math.ceil(Math.log2(m)))}}function tl({layers:n,int8:e}){if(n.length>Rs)throw new B(`a decoder of ${n.length} layers; at most ${Rs}`);let t=e?Math.max(...n.map(({rows:r})=>r)):0;if(t>ks)throw new B(`an int8 layer of ${t} inputs; at most ${ks}`)}function nl(n,e){let t=[],r=bn.map(()=>Ns),i=0;for(let s of n){let a=An(s,e);r[bn.indexOf(Pt(s))]=i;for(let c=0;c<a;c++)t.push(4*i+c);i+=jt(a)}return{places:t,slots:r,queryGroups:i}}var Fr=class{constructor(){this.list=[],this.length=0}add(e){let t=this.length;return this.list.push(e),this.length+=e.length/4,t}all(){let e=new Float32Array(4*this.length),t=0;for(let r of this.list)e.set(r,t),t+=r.length;return e}};function Nn(n,e,t){let r=new Float32Array(4*t);return n.forEach((i,s)=>{r[e?e[s]:s]=i}),r}function Ts(n,{weight:e,bias:t,rows:r,columns:i,step:s=0,scales:a,relu:c},l,h){let p=h||jt(r),m=jt(i),v=new Float32Array(16*p*m);for(let L=0;L<r;L++){let Y=l?l[L]:L,ee=Y>>2;for(let J=0;J<i;J++)v[16*((J>>2)*p+ee)+4*(Y&3)+(J&3)]=e[L*i+J]}let b=n.add(v),S=n.add(Nn(t,null,m)),T=a?n.add(Nn(Float32Array.from(a,L=>L*s),null,m)):0;return{inputs:p,outputs:m,weights:b,bias:S,units:T,relu:c,int8_step:s}}function rl(n,e,{queryGroups:t,gain:r,slots:i,layers:s,matrix:a}){let{resolution:c,channels:l,precision:h,scales:p}=n.planes,{low:m,high:v,top:b,unit:S}=e,T=new Float32Array(12*Ss);for(let L=0;p&&L<3;L++)T.set(p.subarray(L*l,(L+1)*l),4*Ss*L);return fe("RnaPart",{low:n.bounds.min,high:n.bounds.max,resolution:c,channel_groups:jt(l),query_groups:t,layer_count:s.length,plane_precision:ie[`RNA_${h.toUpperCase()}`],gain:r,query_low:m,query_high:v,top:b,unit:S,matrix:a??{},scales:T,layers:s,slots:i})}function In({values:n,resolution:e,channels:t},r){let i=e*e,s=n.subarray(r*i*t,(r+1)*i*t),a=4*jt(t);if(a===t)return s;let c=new n.constructor(i*a);for(let l=0;l<i;l++)c.set(s.subarray(l*t,(l+1)*t),l*a);return c}var Os=`// Input blocks of a decoder (spec, 6.3), in the forms for float32. Each starts at a group of four columns.

uniform bool isFiber;
uniform sampler2DArray planes;  // three planes of \`channel_groups\` layers of four channels

// Features are summed over the planes (spec, 5).
vec4 featuresOf(uint group, vec3 p) {
  float size = float(part.resolution);
  vec4 sum = vec4(0.0);
  for (uint k = 0u; k < 3u; k++) {
    vec2 at = clamp(vec2(p[k], p[(k + 1u) % 3u]) * size - 0.5, 0.0, size - 1.0);
    ivec2 low = ivec2(floor(at)), high = min(low + 1, int(size) - 1);
    vec2 f = at - floor(at);
    int layer = int(k * part.channel_groups + group);
    vec4 lower = mix(texelFetch(planes, ivec3(low, layer), 0), texelFetch(planes, ivec3(high.x, low.y, layer), 0), f.x);
    vec4 upper = mix(texelFetch(planes, ivec3(low.x, high.y, layer), 0), texelFetch(planes, ivec3(high, layer), 0), f.x);
    vec4 scale = part.plane_precision == RNA_INT8 ? part.scales[k * RNA_CHANNEL_GROUPS + group] : vec4(1.0);
    sum += mix(lower, upper, f.y) * scale;
  }
  return sum;
}

vec3 halfway(vec3 wo, vec3 wi, vec3 instead) {
  vec3 s = wi + wo, e = wi - wo;
  float apart = dot(e, e), together = dot(s, s);
  if (together < 1e-12) return instead;
  if (together < apart) s -= e * (dot(s, e) / apart);
  return unit(s);
}

float gap(vec3 n, vec3 m) {
  vec3 d = n - m;
  return log2(0.5 * dot(d, d) + 1e-4) / 6.0;
}

uint slotOf(uint block) {
  return part.slots[block >> 2][block & 3u];
}

bool has(uint block) {
  return slotOf(block) != RNA_NONE;
}

void put(uint block, vec4 value) {
  if (has(block)) values[slotOf(block)] = value;
}

// With the second group of blocks of more than four columns.
void put(uint block, vec4 value, vec4 more) {
  put(block, value);
  if (has(block)) values[slotOf(block) + 1u] = more;
}

void putSurface(vec3 n, vec3 wo, vec3 wi, vec3 features) {
  vec3 m = halfway(wo, wi, n), aside = cross(n, m);
  put(RNA_BLOCK_NORMAL, vec4(n, 0.0));
  put(RNA_BLOCK_HALF_VECTOR, vec4(dot(n, m), gap(n, m), dot(n, wi), dot(n, wo)), vec4(dot(wi, m), 0.0, 0.0, 0.0));
  put(RNA_BLOCK_HIGHLIGHT, vec4(log2(dot(aside, aside) + 1e-8) / 12.0, 0.0, 0.0, 0.0));
  vec3 bent = n + 0.1 * features, q = length(bent) < 1e-6 ? n : unit(bent), learned = halfway(wo, wi, q);
  put(RNA_BLOCK_LEARNED_NORMAL, vec4(dot(q, learned), gap(q, learned), 0.0, 0.0));
}

void putFiber(vec3 t, float h, vec3 wo, vec3 wi) {
  put(RNA_BLOCK_TANGENT, vec4(t, 0.0));
  put(RNA_BLOCK_H, vec4(h, 0.0, 0.0, 0.0));
  vec3 o = cross(t, wo), i = cross(t, wi);
  float so = dot(t, wo), si = dot(t, wi), co = length(o), d = co * length(i), sum = so + si;
  float cosPhi = 1.0, sinPhi = 0.0;
  if (d >= 1e-6) {
    cosPhi = clamp(dot(o, i) / d, -1.0, 1.0);
    sinPhi = clamp(dot(t, cross(o, i)) / d, -1.0, 1.0);
  }
  put(RNA_BLOCK_FIBER_ANGLES, vec4(si, so, sum, log2(sum * sum + 1e-3) / 6.0), vec4(cosPhi, sinPhi, 0.0, 0.0));
  // Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi. As cosine and sine.
  float sinT = h * co / sqrt(1.55 * 1.55 - so * so);
  vec2 lobe = vec2(1.0 - 2.0 * h * h, 2.0 * h * sqrt(max(0.0, 1.0 - h * h)));
  vec2 turn = vec2(2.0 * sinT * sinT - 1.0, 2.0 * sinT * sqrt(max(0.0, 1.0 - sinT * sinT)));
  vec4 lobes = vec4(0.0);
  for (int p = 0; p < 3; p++) {
    lobes[p] = cosPhi * lobe.x + sinPhi * lobe.y;
    lobe = vec2(lobe.x * turn.x - lobe.y * turn.y, lobe.x * turn.y + lobe.y * turn.x);
  }
  put(RNA_BLOCK_FIBER_LOBES, lobes);
}

// Fills \`values\`. x: a position, axis: n or t; all directions unit.
void fillValues(vec3 x, vec3 axis, float h, vec3 wo, vec3 wi) {
  vec3 p = clamp((x - part.low) / (part.high - part.low), 0.0, 1.0);
  vec4 features = featuresOf(0u, p);
  put(RNA_BLOCK_FEATURES, features);
  for (uint group = 1u; has(RNA_BLOCK_FEATURES) && group < part.channel_groups; group++) {
    values[slotOf(RNA_BLOCK_FEATURES) + group] = featuresOf(group, p);
  }
  put(RNA_BLOCK_POSITION, vec4(2.0 * p - 1.0, 0.0));
  put(RNA_BLOCK_WO, vec4(wo, 0.0));
  put(RNA_BLOCK_WI, vec4(wi, 0.0));
  if (isFiber) putFiber(axis, h, wo, wi);
  else putSurface(axis, wo, wi, features.xyz);
}
`;var Is=`// Adds what one light brings, or what the asset emits, to the picture.
precision highp float;
precision highp sampler2D;
uniform sampler2D before;
uniform sampler2D rows0;
uniform sampler2D rows3;
uniform sampler2D lit0;
uniform sampler2D lit1;
uniform sampler2D lit2;
uniform sampler2D first;
uniform sampler2D second;
uniform bool isEmission;
uniform bool countsCoverage;  // once a round
uniform bool isFirst;
uniform int firstRow;
out vec4 sum;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  sum = isFirst ? vec4(0.0) : texelFetch(before, pixel + ivec2(0, firstRow), 0);
  float part = texelFetch(rows0, pixel, 0).w;
  vec3 a = texelFetch(first, pixel, 0).xyz;
  if (isEmission) {
    if (part > 0.0) sum.xyz += texelFetch(rows3, pixel, 0).xyz * a;
    return;
  }
  vec4 light = texelFetch(lit0, pixel, 0), v = texelFetch(lit1, pixel, 0);
  vec3 radiance = texelFetch(lit2, pixel, 0).xyz;
  if (light.w == 1.0) sum.xyz += radiance * mix(texelFetch(second, pixel, 0).xyz, a, v.xyz);
  if (light.w == 2.0) sum.xyz += radiance;
  if (countsCoverage) sum.w += v.w;
}
`;var Ms=`// What the decoder of one part answers for the queries on it.
uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D lit0;
uniform int number;          // of the part
uniform bool hasLight;

layout(location = 0) out vec4 first;   // visible, or emitted
layout(location = 1) out vec4 second;  // shadowed

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0);
  vec4 light = texelFetch(lit0, pixel, 0);
  if (int(row0.w) != number + 1 || (hasLight && light.w != 1.0)) discard;
  vec4 row1 = texelFetch(rows1, pixel, 0);
  vec3 wo = texelFetch(rows2, pixel, 0).xyz, wi = hasLight ? light.xyz : wo;
  first = vec4(0.0, 0.0, 0.0, 1.0);
  second = vec4(0.0, 0.0, 0.0, 1.0);
  if (row1.xyz == vec3(0.0)) return;  // an argument was no direction (spec, 8.1)
  float h = isFiber ? clamp(row1.w, -1.0, 1.0) : 0.0;
  fillValues(row0.xyz, row1.xyz, h, wo, wi);
  decode(first.xyz, second.xyz);
}
`;var Fs=`// The layers of a decoder (spec, 6.4). Values are in groups of four, weights in blocks of 4 x 4: four texels, one of
// outputs for each of four inputs.

uniform sampler2D weights;

vec4 values[GROUPS];
vec4 next[GROUPS];

vec4 weightAt(uint k) {
  return texelFetch(weights, ivec2(k & 1023u, k >> 10), 0);
}

void runLayer(RnaLayer layer) {
  bool isInt8 = layer.int8_step > 0.0;
  if (isInt8) {
    // Products and their sums are whole numbers below 2^24 as long as layers are narrower than 512.
    for (uint i = 0u; i < layer.inputs; i++) values[i] = clamp(roundEven(values[i] / layer.int8_step), 0.0, 255.0);
  }
  uint at = layer.weights;
  for (uint o = 0u; o < layer.outputs; o++) {
    vec4 bias = weightAt(layer.bias + o), sum = isInt8 ? vec4(0.0) : bias;
    for (uint i = 0u; i < layer.inputs; i++, at += 4u) {
      vec4 x = values[i];
      sum += weightAt(at) * x.x + weightAt(at + 1u) * x.y + weightAt(at + 2u) * x.z + weightAt(at + 3u) * x.w;
    }
    if (isInt8) sum = (sum + bias) * weightAt(layer.units + o);
    next[o] = layer.relu == 1u ? max(sum, 0.0) : sum;
  }
  for (uint o = 0u; o < layer.outputs; o++) values[o] = next[o];
}

// The colours, of \`values\` filled with the query.
void decode(out vec3 first, out vec3 second) {
  for (uint i = 0u; i < part.query_groups; i++) {
    vec4 value = clamp(values[i], part.query_low, part.query_high);
    values[i] = part.gain == RNA_NONE ? value : value * weightAt(part.gain + i) + weightAt(part.gain + part.query_groups + i);
  }
  for (uint k = 0u; k < part.layer_count; k++) runLayer(part.layers[k]);
  uint last = part.layers[part.layer_count - 1u].outputs;
  for (uint i = 0u; i < last; i++) values[i] = (exp(clamp(values[i], 0.0, part.top)) - 1.0) * part.unit;
  if (part.matrix.inputs != 0u) runLayer(part.matrix);
  first = max(values[0].xyz, 0.0);
  second = max(vec3(values[0].w, values[1].xy), 0.0);
}
`;var zs=`// A ray from the camera through each pixel, to the query of its first hit.
#include random

uniform vec3 cameraAt;
uniform vec3 corner;       // direction through the image's top left corner
uniform vec3 stepX;        // of a pixel
uniform vec3 stepY;
uniform int height;        // of the picture
uniform int firstRow;      // of the band
uniform float jitter;      // 0: rays through the middles of pixels, 1: anywhere in them

layout(location = 0) out vec4 row0;  // x; part + 1, or 0
layout(location = 1) out vec4 row1;  // n or t; of a fiber h, of a surface b1
layout(location = 2) out vec4 row2;  // wo; place of the primitive
layout(location = 3) out vec4 row3;  // throughput; b2

const int LAYERS_SEEN_THROUGH = 32;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) + ivec2(0, firstRow);
  pixel.y = height - 1 - pixel.y;  // rows from the top, as the random numbers of WebGPU have them
  vec2 at = vec2(pixel) + mix(vec2(0.5), random(pixel, PLACE), jitter);
  vec3 d = normalize(corner + at.x * stepX + at.y * stepY), origin = cameraAt, through = vec3(1.0);
  row0 = vec4(0.0);
  row1 = vec4(0.0);
  row2 = vec4(-d, 0.0);
  row3 = vec4(0.0);
  for (int k = 0; k < LAYERS_SEEN_THROUGH; k++) {
    Hit hit = nearest(origin, d);
    if (hit.t == FAR) break;
    uvec4 primitive = wordsAt(primitives, hit.place);
    bool fiber = isSegment(primitive);
    vec3 tau = fiber ? vec3(0.0) : transmittance(primitive, hit, d);
    float chance = max(tau.x, max(tau.y, tau.z));
    // Straight on, or stopped here: chosen at random (spec, 4.4).
    if (chance > 0.0 && random(pixel, STOPPED + uint(k)).x < chance) {
      through *= tau / chance;
      origin += d * (hit.t + 4.0 * epsilon);
      continue;
    }
    if (chance > 0.0) through *= (1.0 - tau) / (1.0 - chance);
    vec3 x = origin + hit.t * d;
    float part = float(surfaceRow(primitive, 0).y + 1u);
    if (fiber) {
      vec3 t = tangentOf(primitive);
      row1 = vec4(t, offsetAcross(hit.n, t, -d));
    } else {
      x = mixed(cornersOf(primitive).p, weightsOf(hit));
      row1 = vec4(shadingNormal(primitive, hit), hit.b1);
    }
    row0 = vec4(x, part);
    row2.w = float(hit.place);
    row3.w = hit.b2;
    break;
  }
  row3.xyz = through;
}
`;var Cs=`// Where a ray meets a triangle or a round segment (spec, 4.1 and 4.2).

// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): both sides.
struct Shear {
  ivec3 axes;
  vec3 s;
};

Shear shearOf(vec3 d) {
  vec3 a = abs(d);
  int z = a.x > a.y ? 0 : 1;
  if (a.z > a[z]) z = 2;
  int x = (z + 1) % 3, y = (z + 2) % 3;
  return Shear(ivec3(x, y, z), vec3(d[x], d[y], 1.0) / d[z]);
}

bool meetsTriangle(uvec4 primitive, vec3 origin, Shear shear, float far, inout Hit hit) {
  vec3 v[3];
  for (int k = 0; k < 3; k++) {
    vec3 p = valuesAt(points, int(primitive[k])).xyz - origin;
    vec3 q = vec3(p[shear.axes.x], p[shear.axes.y], p[shear.axes.z]);
    v[k] = vec3(q.xy - shear.s.xy * q.z, q.z);
  }
  float u0 = v[2].x * v[1].y - v[2].y * v[1].x;
  float u1 = v[0].x * v[2].y - v[0].y * v[2].x;
  float u2 = v[1].x * v[0].y - v[1].y * v[0].x;
  if (min(u0, min(u1, u2)) < 0.0 && max(u0, max(u1, u2)) > 0.0) return false;
  float sum = u0 + u1 + u2;
  if (sum == 0.0) return false;
  float t = (u0 * v[0].z + u1 * v[1].z + u2 * v[2].z) * shear.s.z / sum;
  if (!(t >= 0.0 && t < far)) return false;
  hit.t = t;
  hit.b1 = u1 / sum;
  hit.b2 = u2 / sum;
  return true;
}

struct Cone {
  vec3 a, b;
  float ra, rb;
};

Cone coneAt(int point) {
  vec4 a = valuesAt(points, point), b = valuesAt(points, point + 1);
  return Cone(a.xyz, b.xyz, a.w, b.w);
}

// The entry into a sphere, from a point near it.
float entersSphere(vec3 origin, vec3 d, vec3 centre, float radius) {
  vec3 between = origin - centre;
  float along = dot(between, d);
  vec3 across = between - along * d;
  float h = radius * radius - dot(across, across);
  return h > 0.0 ? -along - sqrt(h) : 1e30;
}

// The first of all points where the line enters one of the two spheres or the side between them.
bool entersCone(Cone cone, vec3 origin, vec3 d, out float t, out vec3 n) {
  vec3 axis = cone.b - cone.a;
  // From the point of the line nearest to the segment, so that distances do not cancel.
  float shift = dot(0.5 * (cone.a + cone.b) - origin, d);
  vec3 near = (origin - cone.a) + shift * d;
  float dr = cone.ra - cone.rb, length2 = dot(axis, axis), d2 = length2 - dr * dr;
  float ta = entersSphere(near, d, vec3(0.0), cone.ra), tb = entersSphere(near, d, axis, cone.rb);
  t = min(ta, tb);
  n = near + t * d - (ta < tb ? vec3(0.0) : axis);
  if (d2 > 0.0) {
    float m1 = dot(axis, near), m2 = dot(axis, d), m3 = dot(d, near);
    float k2 = d2 - m2 * m2, k1 = d2 * m3 - m1 * m2 + m2 * dr * cone.ra;
    float k0 = d2 * dot(near, near) - m1 * m1 + 2.0 * m1 * dr * cone.ra - length2 * cone.ra * cone.ra;
    float h = k1 * k1 - k0 * k2;
    if (h >= 0.0 && k2 != 0.0) {
      for (float way = -1.0; way < 2.0; way += 2.0) {
        float side = (-k1 + way * sqrt(h)) / k2, y = m1 - cone.ra * dr + side * m2;
        vec3 normal = d2 * (near + side * d) - axis * y;
        if (y > 0.0 && y < d2 && side < t && dot(normal, d) < 0.0) {
          t = side;
          n = normal;
        }
      }
    }
  }
  if (t > 1e29) return false;
  t += shift;
  n = unit(n);
  return true;
}

// How far p is outside of the cone; negative inside.
float distanceTo(Cone cone, vec3 p) {
  vec3 axis = cone.b - cone.a, near = p - cone.a;
  float dr = cone.ra - cone.rb, size = length(axis), y = dot(near, axis) / size, z = y - size;
  float x = length(near - axis * (y / size));
  float toA = length(vec2(x, y)) - cone.ra, toB = length(vec2(x, z)) - cone.rb;
  if (size * size <= dr * dr) return dr > 0.0 ? toA : toB;
  float slope = dr / size, lean = sqrt(1.0 - slope * slope), along = y * lean - x * slope;
  if (along <= 0.0) return toA;
  if (along >= size * lean) return toB;
  return x * lean + y * slope - cone.ra;
}

// An entry inside the segment before or after is no surface.
bool insideNeighbour(int point, uint neighbours, vec3 p) {
  for (int k = 0; k < 2; k++) {
    if ((neighbours & uint(1 + k)) == 0u) continue;
    Cone cone = coneAt(point + (k == 0 ? -1 : 1));
    if (distanceTo(cone, p) < -1e-4 * min(cone.ra, cone.rb)) return true;
  }
  return false;
}

bool meetsSegment(uvec4 primitive, vec3 origin, vec3 d, float far, inout Hit hit) {
  int point = int(primitive.x);
  float t;
  vec3 n;
  if (!entersCone(coneAt(point), origin, d, t, n)) return false;
  if (!(t >= 0.0 && t < far)) return false;
  if (insideNeighbour(point, primitive.y, origin + t * d)) return false;
  hit.t = t;
  hit.n = n;
  return true;
}
`;var Ls=`// For each query a direction of one light, what arrives from there, and how much of it the asset lets through.
#include random

uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
uniform sampler2D given;        // directions, of the conformance kit
uniform int lightKind;          // 0: sun; environment: 1 where it is bright, 3 about the point; 2: given directions
uniform vec3 lightDirection;    // of a sun
uniform vec3 lightColour;       // its irradiance, or a factor of the environment
uniform sampler2D sky;          // the environment's numbers: see light/environment.js
uniform ivec4 skyPlaces;        // of texels, heights, sums of rows, sums of columns
uniform ivec2 skySize;          // width, height
uniform float skyTotal;
uniform vec2 turn;              // cosine and sine of the environment's rotation
uniform vec4 ground;            // height, 1 if there is one, middle x and z
uniform vec3 groundColour;      // radiance of it in full light, over the light's irradiance
uniform float groundSize;
uniform vec3 cameraAt;
uniform int height;
uniform int firstRow;

layout(location = 0) out vec4 lit0;  // wi; 0 nothing, 1 a query, 2 radiance in lit2
layout(location = 1) out vec4 lit1;  // visibility; coverage
layout(location = 2) out vec4 lit2;  // radiance over density, times the throughput

const float PI = 3.14159265358979;

float skyNumber(int at) {
  return valuesAt(sky, at >> 2)[at & 3];
}

// A cell between the middles of four texels, and how bright each is.
struct Cell {
  vec3 a, b, c, d;
  vec4 luminance;
};

vec3 skyTexel(int row, int column) {
  int at = skyPlaces.x + 3 * (clamp(row, 0, skySize.y - 1) * skySize.x + column % skySize.x);
  return vec3(skyNumber(at), skyNumber(at + 1), skyNumber(at + 2));
}

Cell skyCell(int row, int column) {
  vec3 a = skyTexel(row - 1, column), b = skyTexel(row - 1, column + 1);
  vec3 c = skyTexel(row, column), d = skyTexel(row, column + 1), weights = vec3(0.2126, 0.7152, 0.0722);
  return Cell(a, b, c, d, vec4(dot(a, weights), dot(b, weights), dot(c, weights), dot(d, weights)));
}

// Radiance in a cell, bilinear; and the density of brightDirection there, in proportion to its luminance.
vec3 inCell(Cell cell, int row, vec2 f, float sine, out float density) {
  vec3 radiance = mix(mix(cell.a, cell.b, f.x), mix(cell.c, cell.d, f.x), f.y);
  density = dot(radiance, vec3(0.2126, 0.7152, 0.0722)) * float(skySize.x) / (2.0 * PI * max(skyTotal, 1e-30));
  if (row > 0 && row < skySize.y) {
    density *= skyNumber(skyPlaces.y + row) * float(skySize.y) / (PI * max(sine, 1e-30));
  }
  return radiance;
}

vec3 skyAt(vec3 d, out float density) {
  float sine = length(d.xz), azimuth = sine > 0.0 ? atan(d.x, -d.z) : 0.0;
  vec2 at = vec2(0.5 + azimuth / (2.0 * PI), atan(sine, d.y) / PI) * vec2(skySize) + vec2(-0.5, 0.5), low = floor(at);
  int row = clamp(int(low.y), 0, skySize.y), column = (int(low.x) + skySize.x) % skySize.x;
  return inCell(skyCell(row, column), row, at - vec2(low.x, row), sine, density);
}

// The interval of \`count\` running sums from \`first\` on that a value is in; the place in it, from 0 to 1.
int interval(int first, int count, float value, out float place) {
  int low = 0, high = count;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (skyNumber(first + middle) <= value) low = middle;
    else high = middle;
  }
  float before = skyNumber(first + low), size = skyNumber(first + low + 1) - before;
  place = size > 0.0 ? clamp((value - before) / size, 0.0, 0.99999994) : 0.0;
  return low;
}

// A place in [0, 1] with density in proportion to a line from a to b.
float linearPlace(float a, float b, float u) {
  float root = sqrt(max(mix(a * a, b * b, u), 0.0));
  return a + root > 0.0 ? u * (a + b) / (a + root) : u;
}

// A row of cells, a cell of it, and a place in that, in proportion to the luminance; at the poles uniform in the cosine.
vec3 brightDirection(vec2 u) {
  vec2 at;
  int rows = skySize.y, row = interval(skyPlaces.z, rows + 1, u.y * skyNumber(skyPlaces.z + rows + 1), at.y);
  int sums = skyPlaces.w + row * (skySize.x + 1), column = interval(sums, skySize.x, u.x * skyNumber(sums + skySize.x), at.x);
  vec4 l = skyCell(row, column).luminance;
  float cap = 2.0 * asin(sqrt(0.5 * at.y * skyNumber(skyPlaces.y + row))) / PI * float(rows);
  float y = row == 0 ? cap + 0.5 : row == rows ? 0.5 - cap : linearPlace(l.x + l.y, l.z + l.w, at.y);
  float x = linearPlace(mix(l.x, l.z, y), mix(l.y, l.w, y), at.x);
  float theta = PI * (float(row) - 0.5 + y) / float(rows), sine = sin(theta);
  float phi = 2.0 * PI * ((float(column) + 0.5 + x) / float(skySize.x) - 0.5);
  vec3 d = vec3(sine * sin(phi), cos(theta), -sine * cos(phi));
  return vec3(turn.x * d.x + turn.y * d.z, d.y, turn.x * d.z - turn.y * d.x);
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
  vec3 n;  // turned to the viewer
  vec3 mirror;
};

const float MIRRORED = 1.0 / 3.0, MIRROR_KAPPA = 20.0;  // of a von Mises-Fisher distribution
const float FROM_ALL_SIDES = 0.25, EVEN = 0.25 / PI;

float mirroredShare(Surroundings at) {
  return at.mirror == vec3(0.0) ? 0.0 : MIRRORED;
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
vec3 along(vec3 axis, float cosine, float phi) {
  float side = axis.z < 0.0 ? -1.0 : 1.0, c = -1.0 / (side + axis.z), d = axis.x * axis.y * c;
  vec3 s = vec3(1.0 + side * axis.x * axis.x * c, side * d, -side * axis.x);
  vec3 t = vec3(d, side + axis.y * axis.y * c, -axis.y);
  return normalize(sqrt(max(0.0, 1.0 - cosine * cosine)) * (cos(phi) * s + sin(phi) * t) + cosine * axis);
}

vec3 directionAbout(Surroundings at, vec2 u) {
  float share = mirroredShare(at), phi = 2.0 * PI * u.x;
  if (u.y < share) {
    float v = u.y / share;
    return along(at.mirror, 1.0 + log(v + (1.0 - v) * exp(-2.0 * MIRROR_KAPPA)) / MIRROR_KAPPA, phi);
  }
  float rest = (u.y - share) / (1.0 - share);
  bool allSides = rest < FROM_ALL_SIDES;
  float v = allSides ? rest / FROM_ALL_SIDES : (rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES);
  vec3 ball = along(vec3(0.0, 0.0, 1.0), 1.0 - 2.0 * v, phi);
  return normalize(ball + (allSides ? vec3(0.0) : at.n * 1.0001));
}

float densityAbout(Surroundings at, vec3 wi) {
  if (at.n == vec3(0.0)) return EVEN;
  float rest = mix(max(0.0, dot(at.n, wi)) / PI, EVEN, FROM_ALL_SIDES);
  float fisher = MIRROR_KAPPA / (2.0 * PI) * exp(MIRROR_KAPPA * (dot(at.mirror, wi) - 1.0));
  return mix(rest, fisher, mirroredShare(at));
}

Surroundings surroundingsOf(vec4 row0, vec4 row1, vec4 row2) {
  if (row0.w == 0.0) return Surroundings(vec3(0.0, 1.0, 0.0), vec3(0.0));  // of the ground
  if (isSegment(wordsAt(primitives, int(row2.w)))) return Surroundings(vec3(0.0), vec3(0.0));
  vec3 n = row1.xyz, wo = row2.xyz;
  return Surroundings(dot(n, wo) < 0.0 ? -n : n, reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
vec3 sampleLight(ivec2 pixel, Surroundings at, out vec3 wi) {
  if (lightKind == 0 || lightKind == 2) {
    wi = lightKind == 0 ? lightDirection : texelFetch(given, pixel, 0).xyz;
    return lightColour;
  }
  vec2 u = random(ivec2(pixel.x, height - 1 - pixel.y - firstRow), DIRECTION);
  wi = lightKind == 1 ? brightDirection(u) : directionAbout(at, u);
  vec3 d = vec3(turn.x * wi.x - turn.y * wi.z, wi.y, turn.x * wi.z + turn.y * wi.x);
  float density;
  vec3 radiance = skyAt(d, density);
  return lightColour * radiance / (density + densityAbout(at, wi));
}

// Where a ray to the light starts, and what it may bring.
struct Start {
  vec3 origin;
  uint strand;  // that is no obstacle
  vec3 weight;
  float coverage;
};

Start startOf(vec4 row0, vec4 row1, vec4 row2, float b2, vec3 wi) {
  int place = int(row2.w);
  uvec4 primitive = wordsAt(primitives, place);
  if (isSegment(primitive)) return Start(row0.xyz, primitive.z, vec3(1.0), 1.0);
  Hit hit = Hit(0.0, place, row1.w, b2, vec3(0.0));
  return Start(liftedOrigin(primitive, hit, wi), NONE, vec3(1.0), 1.0);
}

// The ground shows the shadow, and fades with the distance.
Start startOnGround(vec3 d, vec3 wi) {
  if (ground.y == 0.0 || d.y * (cameraAt.y - ground.x) >= 0.0) return Start(vec3(0.0), NONE, vec3(0.0), 0.0);
  vec3 x = cameraAt + d * ((ground.x - cameraAt.y) / d.y);
  float fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - ground.zw) / groundSize);
  return Start(x + vec3(0.0, epsilon, 0.0), NONE, fade * max(0.0, wi.y) * groundColour, fade);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0), row1 = texelFetch(rows1, pixel, 0);
  vec4 row2 = texelFetch(rows2, pixel, 0), row3 = texelFetch(rows3, pixel, 0);
  bool isQuery = row0.w != 0.0;
  vec3 wi, radiance = row3.xyz * sampleLight(pixel, surroundingsOf(row0, row1, row2), wi);
  Start start;
  if (isQuery) start = startOf(row0, row1, row2, row3.w, wi);
  else start = startOnGround(-row2.xyz, wi);
  bool needed = any(greaterThan(start.weight, vec3(0.0)));
  vec3 passed = needed ? passes(start.origin, wi, start.strand) : vec3(0.0);
  lit0 = vec4(wi, isQuery ? 1.0 : 2.0);
  lit1 = vec4(passed, start.coverage);
  lit2 = vec4(isQuery ? radiance : start.weight * passed * radiance, 0.0);
}
`;var Ps=`// The normals of hits whose place and barycentric coordinates are in the rows.
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int place = int(texelFetch(rows2, pixel, 0).w);
  Hit hit = Hit(0.0, place, texelFetch(rows1, pixel, 0).w, texelFetch(rows3, pixel, 0).w, vec3(0.0));
  first = vec4(shadingNormal(wordsAt(primitives, place), hit), 1.0);
  second = vec4(0.0);
}
`;var Ds=`// What a hit is on: normals, relief, transmittance (spec, 4.1, 4.4, 4.5), and its own ray to the light (7.1).

struct Corners {
  vec3 p[3], n[3];
  vec2 uv[3];
};

Corners cornersOf(uvec4 primitive) {
  Corners corners;
  for (int k = 0; k < 3; k++) {
    vec4 place = valuesAt(points, int(primitive[k])), normal = valuesAt(normals, int(primitive[k]));
    corners.p[k] = place.xyz;
    corners.n[k] = normal.xyz;
    corners.uv[k] = vec2(place.w, normal.w);
  }
  return corners;
}

vec3 weightsOf(Hit hit) {
  return vec3(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2);
}

vec3 mixed(vec3 v[3], vec3 b) {
  return b.x * v[0] + b.y * v[1] + b.z * v[2];
}

vec2 uvOf(Corners corners, vec3 b) {
  return b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
}

// The bilinear lookup of 4.4, in values from 0 to 255; the texture repeats.
vec3 lookUp(uint image, vec2 uv) {
  uvec4 record = wordsAt(surfaces, texturesAt + TEXTURE_ROWS * int(image));
  ivec2 size = ivec2(record.y & 0xffffu, record.y >> 16u);
  vec2 place = uv * vec2(size) - 0.5, low = floor(place), f = place - low;
  // Repeat before integers: coordinates may be large.
  ivec2 at = clamp(ivec2(low - vec2(size) * floor(low / vec2(size))), ivec2(0), size - 1), next = (at + 1) % size;
  ivec4 places = int(record.x) + ivec4(at.y, at.y, next.y, next.y) * size.x + ivec4(at.x, next.x, at.x, next.x);
  vec3 lower = mix(vec3(wordsAt(texels, places.x).xyz), vec3(wordsAt(texels, places.y).xyz), f.x);
  vec3 upper = mix(vec3(wordsAt(texels, places.z).xyz), vec3(wordsAt(texels, places.w).xyz), f.x);
  return mix(lower, upper, f.y);
}

float fresnel(float index, float c) {
  float g2 = index * index - 1.0 + c * c;
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2), r = (g - c) / (g + c), s = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return clamp(0.5 * r * r * (1.0 + s * s), 0.0, 1.0);
}

vec3 transmittance(uvec4 primitive, Hit hit, vec3 d) {
  uint flags = surfaceRow(primitive, 0).z;
  if ((flags & LETS_THROUGH) == 0u) return vec3(0.0);
  uvec4 rule = surfaceRow(primitive, THROUGH_ROW);  // texture, cutoff, indices of refraction
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit), tau = lookUp(rule.x, uvOf(corners, b)) / 255.0, index = uintBitsToFloat(rule.yzw);
  if ((flags & HAS_CUTOFF) != 0u) tau = vec3(tau.x > index.x ? 1.0 : 0.0);
  if (index.y > 0.0) {
    vec3 n = unit(mixed(corners.n, b)), ng = cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]);
    tau *= 1.0 - fresnel(dot(d, ng) < 0.0 ? index.y : index.z, abs(dot(n, d)));
  }
  return tau;
}

// The normal with relief, 4.5.
vec3 mappedNormal(uint map, Corners corners, vec3 b, vec3 n) {
  if (map == NONE) return n;
  vec3 e1 = corners.p[1] - corners.p[0], e2 = corners.p[2] - corners.p[0];
  vec2 a = corners.uv[1] - corners.uv[0], c = corners.uv[2] - corners.uv[0];
  float area = a.x * c.y - c.x * a.y;
  if (area == 0.0) return n;
  vec3 u = (c.y * e1 - a.y * e2) * sign(area), v = (a.x * e2 - c.x * e1) * sign(area);
  vec3 along = u - dot(u, n) * n;
  if (length(along) <= 1e-6 * length(u)) return n;
  vec3 t = unit(along), up = cross(n, t);
  if (dot(up, v) > 0.0) up = -up;
  vec2 q = (lookUp(map, uvOf(corners, b)).xy - 127.0) / 127.0;
  vec3 m = q.x * t + q.y * up + sqrt(max(0.0, 1.0 - dot(q, q))) * n;
  return length(m) <= 1e-6 ? n : normalize(m);
}

vec3 shadingNormal(uvec4 primitive, Hit hit) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit);
  return mappedNormal(surfaceRow(primitive, 0).w, corners, b, unit(mixed(corners.n, b)));
}

vec3 tangentOf(uvec4 primitive) {
  return unit(valuesAt(points, int(primitive.x) + 1).xyz - valuesAt(points, int(primitive.x)).xyz);
}

// h of 4.2.
float offsetAcross(vec3 n, vec3 t, vec3 wo) {
  vec3 across = cross(t, wo);
  float size = length(across);
  return size > 1e-6 ? clamp(dot(n, across) / size, -1.0, 1.0) : 0.0;
}

// Where the visibility ray of a mesh starts.
vec3 liftedOrigin(uvec4 primitive, Hit hit, vec3 wi) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit), x = mixed(corners.p, b), n = unit(mixed(corners.n, b));
  vec3 ng = unit(cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]));
  float side = dot(ng, wi) < 0.0 ? -1.0 : 1.0;
  if (dot(n, wi) > 0.0 && dot(n, ng) > 0.0 && dot(ng, wi) < 0.1) {
    vec3 lift = vec3(0.0);
    for (int k = 0; k < 3; k++) lift += b[k] * max(0.0, dot(corners.p[k] - x, corners.n[k])) * corners.n[k];
    x += (1.0 - max(0.0, dot(ng, wi)) / 0.1) * lift;
    side = 1.0;
  }
  return x + side * epsilon * ng;
}
`;var Us=`// Numbers in [0, 1). Of a pixel's place and of the light: of each pixel a start of its own, and from there the additive
// recurrence in four dimensions (Roberts 2018), so that the samples of a pixel are spread evenly. All others: hashed.

uniform uint sampleNumber;

uint hashed(uint x) {  // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

const uint PLACE = 0u, DIRECTION = 1u, STOPPED = 2u;  // and those behind it

vec2 random(ivec2 pixel, uint dimension) {
  uint own = dimension >= STOPPED ? sampleNumber : 0u;
  uint seed = hashed(uint(pixel.x) + hashed(uint(pixel.y) + hashed(dimension + hashed(own))));
  vec2 start = vec2(seed >> 8u, hashed(seed) >> 8u) / 16777216.0;
  if (dimension >= STOPPED) return start;
  // In whole numbers: floats of later samples would lose digits.
  uvec2 turn = dimension == DIRECTION ? uvec2(2700274805u, 2313257605u) : uvec2(3679390609u, 3152041523u);
  return fract(start + vec2((turn * sampleNumber) >> 8u) / 16777216.0);
}
`;var zr=`// The asset's geometry in textures: see geometry/scene_arrays.js.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;

uniform usampler2D nodes;       // two texels a node: min, right child or first primitive; max, number of primitives
uniform usampler2D primitives;  // one a primitive, in the order of the leaves; last twice the surface, + 1 of a segment
uniform sampler2D points;       // position, and u or the radius
uniform sampler2D normals;      // normal and v
uniform usampler2D surfaces;    // rows of surfaces, then of textures: see geometry/surface_table.js
uniform usampler2D texels;      // of textures
uniform int texturesAt;
uniform float epsilon;          // the spec's e, 7.1

const uint NONE = 0xffffffffu;

uvec4 wordsAt(usampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

vec4 valuesAt(sampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

bool isSegment(uvec4 primitive) {
  return (primitive.w & 1u) != 0u;
}

uvec4 surfaceRow(uvec4 primitive, int k) {
  return wordsAt(surfaces, SURFACE_ROWS * int(primitive.w >> 1u) + k);
}

struct Hit {
  float t;
  int place;       // of the primitive in the table
  float b1, b2;    // barycentric coordinates
  vec3 n;          // of a segment, outward
};

vec3 unit(vec3 v) {
  vec3 size = abs(v);
  float largest = max(size.x, max(size.y, size.z));
  return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}
`;var Bs=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
uniform float rounds;
uniform float exposure;  // a factor
uniform float filmicView;  // 1 for the filmic view transform, 0 for none
uniform float spread;    // of noise, in values of the screen; 0 to leave it
uniform vec3 backdrop;   // linear light of the screen
uniform vec2 size;       // of the canvas, pixels
out vec4 colour;

vec4 at(ivec2 place) {
  return texelFetch(picture, clamp(place, ivec2(0), textureSize(picture, 0) - 1), 0);
}

// As rna_render/image/view_transform.py, which names the source.
vec3 filmic(vec3 radiance) {
  vec3 c = 1.461926 * min(radiance, vec3(1e9));
  vec3 x = vec3(dot(c, vec3(0.59719, 0.35458, 0.04823)), dot(c, vec3(0.07600, 0.90834, 0.01566)),
                dot(c, vec3(0.02840, 0.13383, 0.83777)));
  // Both parts divided by x, so that none overflows.
  vec3 inv = 1.0 / max(x, vec3(1e-9));
  vec3 y = (x + 0.0245786 - 0.000090537 * inv) / (0.983729 * x + 0.4329510 + 0.238081 * inv);
  return vec3(dot(y, vec3(1.60475, -0.53108, -0.07367)), dot(y, vec3(-0.10208, 1.10813, -0.00605)),
              dot(y, vec3(-0.00327, -0.07276, 1.07602)));
}

// Values of the screen, sRGB, of a mean.
vec3 displayed(vec4 mean) {
  vec3 exposed = max(mean.xyz * exposure, vec3(0.0));
  vec3 light = filmicView > 0.5 ? filmic(exposed) : exposed;
  vec3 linear = clamp(light, 0.0, 1.0) + max(0.0, 1.0 - mean.w) * backdrop;
  vec3 encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
  return clamp(encoded, 0.0, 1.0);
}

void main() {
  vec2 scale = vec2(textureSize(picture, 0)) / size;
  vec2 place = gl_FragCoord.xy * scale - 0.5, low = floor(place), f = place - low;
  ivec2 a = ivec2(low);
  vec4 mean = mix(mix(at(a), at(a + ivec2(1, 0)), f.x), mix(at(a + ivec2(0, 1)), at(a + ivec2(1, 1)), f.x), f.y) / rounds;
  vec3 here = displayed(mean);
  colour = vec4(here, 1.0);
  if (spread == 0.0) return;
  // Bilateral: neighbours count by how near and how like they are.
  vec4 sum = vec4(here, 1.0);
  vec2 middle = floor(place + 0.5);
  for (float dy = -2.0; dy <= 2.0; dy += 1.0) {
    for (float dx = -2.0; dx <= 2.0; dx += 1.0) {
      vec2 there = middle + vec2(dx, dy), away = there - place;
      vec4 other = at(ivec2(there)) / rounds;
      vec3 value = displayed(other), unlike = (value - here) / spread;
      float edge = 4.0 * (other.w - mean.w);
      sum += vec4(value, 1.0) * exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
    }
  }
  colour = vec4(sum.xyz / sum.w, 1.0);
}
`;var $s=`// Rays against the hierarchy: the nearest hit, and how much light passes (spec, 7.1).

const int STACK = 48, ROOT = 1;  // node 0 is rna_gpu's, of the only instance
const float FAR = 1e30;

// No axis is exactly parallel: 0 times infinity would be no number.
vec3 inverseOf(vec3 d) {
  vec3 tiny = vec3(1e-20);
  return 1.0 / mix(d, tiny, lessThan(abs(d), tiny));
}

// Where a ray enters the box of a node, FAR if not.
float boxAt(int node, vec3 origin, vec3 inverse, float far) {
  vec3 a = (uintBitsToFloat(wordsAt(nodes, 2 * node).xyz) - origin) * inverse;
  vec3 b = (uintBitsToFloat(wordsAt(nodes, 2 * node + 1).xyz) - origin) * inverse, low = min(a, b), high = max(a, b);
  float near = max(max(low.x, low.y), max(low.z, 0.0)), last = min(min(high.x, high.y), min(high.z, far)) * 1.0000004;
  return near <= last ? near : FAR;
}

// The nearest hit of a ray, in \`hit\`, of which t is FAR for none; or, if it weakens, the light that passes to infinity.
// Strand \`own\` is no obstacle.
vec3 traced(vec3 origin, vec3 d, uint own, bool weakens, out Hit hit) {
  hit = Hit(FAR, 0, 0.0, 0.0, vec3(0.0));
  vec3 light = vec3(1.0), inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = ROOT;
  if (boxAt(ROOT, origin, inverse, FAR) == FAR) return light;
  for (;;) {
    int first = int(wordsAt(nodes, 2 * node).w), count = int(wordsAt(nodes, 2 * node + 1).w);
    for (int k = first; k < first + count; k++) {
      uvec4 primitive = wordsAt(primitives, k);
      bool segment = isSegment(primitive);
      if (segment && primitive.z == own) continue;
      bool met = segment ? meetsSegment(primitive, origin, d, hit.t, hit) : meetsTriangle(primitive, origin, shear, hit.t, hit);
      if (!met) continue;
      hit.place = k;
      if (!weakens) continue;
      light *= segment ? vec3(0.0) : transmittance(primitive, hit, d);
      if (light == vec3(0.0)) return light;
      hit.t = FAR;
    }
    if (count == 0) {
      int left = node + 1, right = first;
      float a = boxAt(left, origin, inverse, hit.t), b = boxAt(right, origin, inverse, hit.t);
      if (max(a, b) < FAR) stack[top++] = a <= b ? right : left;
      if (min(a, b) < FAR) {
        node = a <= b ? left : right;
        continue;
      }
    }
    if (top == 0) return light;
    node = stack[--top];
  }
}

Hit nearest(vec3 origin, vec3 d) {
  Hit hit;
  traced(origin, d, NONE, false, hit);
  return hit;
}

vec3 passes(vec3 origin, vec3 d, uint own) {
  Hit hit;
  return traced(origin, d, own, true, hit);
}
`;var{LETS_THROUGH:vl,HAS_CUTOFF:yl}=ie,{Surface:Hs,Texture:wl}=Ee,qs=`precision highp int;
const int SURFACE_ROWS = ${Hs.words/4}, THROUGH_ROW = ${Hs.members.through.at/4}, TEXTURE_ROWS = ${wl.words/4};
const uint LETS_THROUGH = ${vl}u, HAS_CUTOFF = ${yl}u;
`,Cr=[qs,zr,Cs,Ds,$s].join(`
`),Gs=n=>n.replace("#include random",Us),Mn={hit:Cr+Gs(zs),light:Cr+Gs(Ls),normals:Cr+Ps,decode:(n,e)=>[qs,zr,n,`const int GROUPS = ${e};`,Fs,Os,Ms].join(`
`),clear:"precision highp float; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = b = vec4(0.0); }",combine:Is,show:Bs};function js(n,e){let{resolution:t,channels:r,precision:i}=e,s=Math.ceil(r/4),a=n.getParameter(n.MAX_TEXTURE_SIZE);if(t>a)throw new B(`planes of ${t} texels a side; this device has ${a}`);let c=n.createTexture();n.bindTexture(n.TEXTURE_2D_ARRAY,c),n.pixelStorei(n.UNPACK_ALIGNMENT,1);let l=i==="float32"?n.RGBA32F:n.RGBA16F,h=i==="float16"?n.HALF_FLOAT:n.FLOAT;n.texStorage3D(n.TEXTURE_2D_ARRAY,1,l,t,t,3*s),Mr(n,n.TEXTURE_2D_ARRAY);let p=new(i==="float16"?Uint16Array:Float32Array)(4*t*t);for(let m=0;m<3;m++){let v=In(e,m);for(let b=0;b<s;b++){for(let S=0;S<p.length;S++)p[S]=v[4*((S>>2)*s+b)+(S&3)];n.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,m*s+b,t,t,1,n.RGBA,h,p)}}return{target:n.TEXTURE_2D_ARRAY,texture:c}}function Zs(n){return Object.entries(Ee[n].members).map(([e,{type:t,record:r,count:i}])=>{let[s,a]=t==="f32"?["float","vec"]:["uint","uvec"];return r?`${r} ${e}${i>1?`[${i}]`:""};`:i>4?`${a}4 ${e}[${Math.ceil(i/4)}];`:`${i>1?a+i:s} ${e};`}).join(" ")}var _l=`struct RnaLayer { ${Zs("RnaLayer")} };
layout(std140) uniform Part { ${Zs("RnaPart")} } part;
${Object.entries(ie).filter(([n])=>n.startsWith("RNA_")).map(([n,e])=>`const uint ${n} = ${e}u;`).join(`
`)}
`,Wt=class{constructor(e,t,r,i,s,a){let{weights:c,record:l,groups:h}=On(r,i,s);this.weights=Fe(e,c,1024),this.planes=a,this.record=e.createBuffer(),e.bindBuffer(e.UNIFORM_BUFFER,this.record),e.bufferData(e.UNIFORM_BUFFER,l,e.STATIC_DRAW),this.program=new bt(e,Mn.decode(_l,h)),this.uniforms={number:["1i",t],isFiber:["1i",+(r.kind==="fiber")],hasLight:["1i",+(i.outputs===6)]}}get textures(){return{planes:this.planes,weights:this.weights}}delete(e){this.program.delete(),e.deleteBuffer(this.record),e.deleteTexture(this.weights.texture)}};var xl=1<<17,Fn=class n{static label="WebGL2";static async open(e){let t=bs(e),r=new n;Object.assign(r,{gl:t,canvas:e,parts:[],target:null,lost:!1,bandPixels:xl}),r.programs=Object.fromEntries(["hit","light","normals","clear","combine","show"].map(i=>[i,new bt(t,Mn[i])]));for(let i of Object.values(r.programs))i.check();return e.addEventListener("webglcontextlost",i=>{i.preventDefault(),r.lost=!0,r.onlost?.("the WebGL context was lost")}),r}setAsset(e,t){let{gl:r}=this;this._deleteAsset(),this.asset={nodes:Fe(r,e.nodes),primitives:Fe(r,e.primitives),points:Fe(r,e.points),normals:Fe(r,e.normals),surfaces:Fe(r,e.table),texels:Fe(r,new Uint8Array(e.images.buffer))},this.geometry={texturesAt:["1i",e.texturesAt],epsilon:["1f",e.extent*2**-18]},this.parts=t.map((i,s)=>{let a=js(r,i.planes),c=new Wt(r,s,i,i.transport,i.inputs,a),l=i.emission&&new Wt(r,s,i,i.emission,i.emission.inputs,a);return{planes:a,transport:c,emission:l}});for(let{transport:i,emission:s}of this.parts)i.program.check(),s?.program.check()}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment({floats:e,places:t,total:r,width:i,height:s}){this.sky&&this.gl.deleteTexture(this.sky.texture),this.sky=Fe(this.gl,e),this.skyNumbers={skyPlaces:["4i",...t],skySize:["2i",i,s],skyTotal:["1f",r]}}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let{gl:r}=this,i=Math.max(1,Math.min(t,Math.floor(this.bandPixels/e)));this._deleteImages(),this.target={width:e,height:t},this.rows=new Ye(r,e,i,4),this.lit=new Ye(r,e,i,3),this.answers=new Ye(r,e,i,2),this.added=new Ye(r,e,i,1),this.sum=new Ye(r,e,t,1)}trace(e,t,r,i){let{height:s}=this.target;this.span={rows:i-r,firstRow:s-i};let{position:a,corner:c,stepX:l,stepY:h,jitter:p=1}=e;this.frame={cameraAt:["3fv",a],height:["1i",s],firstRow:["1i",this.span.firstRow],sampleNumber:["1ui",t]},this._pass("hit",this.rows,this.asset,{...this.geometry,...this.frame,jitter:["1f",p],corner:["3fv",c],stepX:["3fv",l],stepY:["3fv",h]})}light(e,{isFirst:t,countsCoverage:r}){this._light(e),this._decode("transport"),this._combine({isFirst:t,countsCoverage:r,isEmission:!1})}_light(e,t=null){let[r,i,s,a]=this.rows.images;this._pass("light",this.lit,{...this.asset,rows0:r,rows1:i,rows2:s,rows3:a,given:t??r,sky:this.sky??r},{...this.geometry,...this.frame,...this.skyNumbers,...Al(e)})}emission(){this._pass("clear",this.answers,{},{}),this._decode("emission"),this._combine({isFirst:!1,countsCoverage:!1,isEmission:!0})}_combine({isEmission:e,countsCoverage:t,isFirst:r}){let{gl:i}=this,{width:s}=this.target,{rows:a,firstRow:c}=this.span,[l,,,h]=this.rows.images,[p,m,v]=this.lit.images,[b,S]=this.answers.images,T=L=>["1i",Number(L)];this._pass("combine",this.added,{before:this.sum.images[0],rows0:l,rows3:h,lit0:p,lit1:m,lit2:v,first:b,second:S},{isEmission:T(e),countsCoverage:T(t),isFirst:T(r),firstRow:["1i",c]}),i.bindFramebuffer(i.READ_FRAMEBUFFER,this.added.frame),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,this.sum.frame),i.disable(i.SCISSOR_TEST),i.blitFramebuffer(0,0,s,a,0,c,s,c+a,i.COLOR_BUFFER_BIT,i.NEAREST)}_pass(e,t,r,i){Tn(this.gl,this.programs[e],t,{to:this.span.rows,textures:r,uniforms:i})}show({rounds:e,exposure:t,backdrop:r,filmic:i,spread:s}){let{width:a,height:c}=this.canvas;Tn(this.gl,this.programs.show,null,{textures:{picture:this.sum.images[0]},uniforms:{rounds:["1f",e],exposure:["1f",t],backdrop:["3fv",r],size:["2f",a,c],filmicView:["1f",Number(i)],spread:["1f",s]}})}done(){return Es(this.gl)}async picture(){let{width:e,height:t}=this.target,r=this.sum.read(0),i=new Float32Array(r.length);for(let s=0;s<t;s++)i.set(r.subarray(4*e*s,4*e*(s+1)),4*e*(t-1-s));return i}_decode(e){let[t,r,i]=this.rows.images,s=this.lit.images[0];for(let a of this.parts){let c=a[e];c&&(this.gl.bindBufferBase(this.gl.UNIFORM_BUFFER,0,c.record),Tn(this.gl,c.program,this.answers,{to:this.span.rows,textures:{...c.textures,rows0:t,rows1:r,rows2:i,lit0:s},uniforms:c.uniforms}))}}_deleteAsset(){for(let{texture:e}of Object.values(this.asset??{}))this.gl.deleteTexture(e);for(let{planes:e,transport:t,emission:r}of this.parts)this.gl.deleteTexture(e.texture),t.delete(this.gl),r?.delete(this.gl);this.parts=[]}_deleteImages(){for(let e of[this.rows,this.lit,this.answers,this.added,this.sum])e?.delete();this.target=null}close(){this._deleteAsset(),this._deleteImages();for(let e of Object.values(this.programs))e.delete()}},bl={sun:0,environment:1,given:2,aroundPoint:3};function Al({kind:n,direction:e=[0,1,0],colour:t,angle:r=0,ground:i}){return{lightKind:["1i",bl[n]],lightDirection:["3fv",e],lightColour:["3fv",t],turn:["2f",Math.cos(r),Math.sin(r)],ground:["4f",i?.height??0,i?1:0,i?.x??0,i?.z??0],groundColour:["3fv",i?.colour??[0,0,0]],groundSize:["1f",i?.size??1]}}var Yt={surface:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","surface_blocks.wgsl","decoder.wgsl","surface.wgsl"],fiber:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","fiber_blocks.wgsl","decoder.wgsl","fiber.wgsl"],evaluate:["arguments.wgsl","evaluate.wgsl"],"render/step":["render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl","render/sampler.wgsl"],"render/scene":["render/step","geometry_records.wgsl","geometry.wgsl","segment.wgsl","normal_maps.wgsl","visibility.wgsl","render/surfaces.wgsl","render/textures.wgsl","render/transmittance.wgsl","render/bumps.wgsl","render/vertex.wgsl"],"render/lit":["render/directions.wgsl","render/lights.wgsl","render/environment.wgsl","render/triangle_lights.wgsl"],"render/traced":["triangle.wgsl","bvh.wgsl","render/light_shapes.wgsl","render/passing.wgsl","render/tracing.wgsl"],rays:["render/scene","triangle.wgsl","bvh.wgsl","render/passing.wgsl","render/tracing.wgsl"],hit:["rays"],light:["rays","render/lit","render/light_shapes.wgsl","render/lobe_constants.wgsl"],queue:["render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl"]},At={"arguments.wgsl":`// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
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
    let first = rna_features(texels, 0u);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    if slot != RNA_NONE {
        rna_values[slot] = first;
        for (var group = 1u; group < rna_part.channel_groups; group++) {
            rna_values[slot + group] = rna_features(texels, group);
        }
    }
    rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    return first.xyz;
}

// Halfway between wo and wi, \`instead\` where they are opposite ("In float32": the difference of
// their lengths goes).
fn rna_halfway(wo: vec3f, wi: vec3f, instead: vec3f) -> vec3f {
    var s = wi + wo;
    let e = wi - wo;
    let square = dot(e, e);
    if dot(s, s) < square {
        s -= e * (dot(s, e) / square);
    }
    let size = length(s);
    if size < 1e-6 {
        return instead;
    }
    return s / size;
}
`,"bvh.wgsl":`// Closest and any hits: a tree over instances, and one in each body's object space. Loops take
// their lengths from the data. Of every hit of a triangle they ask
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

// The next node down, nearer child first; RNA_NOTHING where none is met.
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

// Tests a primitive; whether it is met, nearer than \`hit\`, which then becomes it.
fn rna_meet(primitive: u32, ray: RnaRay, own_strand: u32, hit: ptr<function, RnaHit>) -> bool {
    let record = rna_primitives[primitive];
    let line = RnaRay(ray.origin, ray.near, ray.direction, (*hit).t);
    if (record.w & 1u) == 0u {
        let found = rna_meet_triangle(
            line, rna_points[record.x].xyz, rna_points[record.y].xyz, rna_points[record.z].xyz,
        );
        if found.x >= RNA_FAR || !rna_stops(primitive, ray, found, (*hit).instance) {
            return false;
        }
        *hit = RnaHit(found.x, (*hit).instance, primitive, found.y, found.z, vec3f(0.0));
        return true;
    }
    if record.z == own_strand {
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
    root: u32, ray: RnaRay, own_strand: u32, any: bool, hit: ptr<function, RnaHit>,
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
            if rna_meet(first + k, ray, own_strand, hit) {
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
// that are unrolled take minutes to compile.

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

// The colours for the queries in rna_values.
fn rna_decode() -> RnaTransport {
    rna_prepare_queries();
    var source = 0u;
    for (var k = 0u; k < rna_part.layer_count; k++) {
        rna_run_layer(rna_part.layers[k], source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    let last = rna_part.layers[rna_part.layer_count - 1u].outputs;
    for (var k = 0u; k < last; k++) {
        let x = clamp(rna_values[source + k], vec4f(0.0), vec4f(rna_part.top));
        rna_values[source + k] = (exp(x) - 1.0) * rna_part.unit;
    }
    if rna_part.matrix.inputs != 0u {
        rna_run_layer(rna_part.matrix, source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    let first = rna_values[source];
    let second = rna_values[source + 1u];
    let visible = max(first.xyz, vec3f(0.0));
    return RnaTransport(visible, max(vec3f(first.w, second.xy), vec3f(0.0)));
}
`,"evaluate.wgsl":`// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<vec4<u32>>; // 4 a row, see README.md
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
    let position = rna_rows[4u * row];
    let axis = rna_rows[4u * row + 1u].xyz;
    let wo = rna_rows[4u * row + 2u].xyz;
    let wi = rna_rows[4u * row + 3u].xyz;
    let finite = rna_is_finite(position) && rna_is_finite(vec4<u32>(axis, 0u))
        && rna_is_finite(vec4<u32>(wo, 0u)) && rna_is_finite(vec4<u32>(wi, 0u));
    let a = rna_unit(axis);
    let o = rna_unit(wo);
    let i = rna_unit(wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        result = rna_query(bitcast<vec3f>(position.xyz), a, bitcast<f32>(position.w), o, i);
    }
    rna_write(row, result);
}
`,"fiber.wgsl":`// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_common_blocks(x, wo, wi);
    rna_fiber_blocks(t, clamp(h, -1.0, 1.0), wo, wi);
    return rna_decode();
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

// A triangle: three points and 2 surface. A segment: its first point, neighbours on its strand
// (1: before, 2: after), strand and 2 surface + 1.
@group(2) @binding(1) var<storage, read> rna_primitives: array<vec4<u32>>;

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

const RNA_NOTHING: u32 = 0xffffffffu;

fn rna_miss(far: f32) -> RnaHit {
    return RnaHit(far, RNA_NOTHING, 0u, 0.0, 0.0, vec3f(0.0));
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

struct RnaNode { // 32 bytes
    low: vec3f, // 0
    child: u32, // 12; the right one, the left one is the next node; a leaf's first primitive
    high: vec3f, // 16
    count: u32, // 28; a leaf's primitives; 0 of inner nodes
}

struct RnaInstance { // 128 bytes
    to_object: array<vec4f, 3>, // 0; rows of the matrix
    rotation: array<vec4f, 3>, // 48; to the world: rows, the fourth column free
    place: vec3f, // 96; in the world
    scale: f32, // 108; to the world
    root: u32, // 112; node
    rays: u32, // 116; bits of those that meet it
    extent: f32, // 120; largest coordinate of its body
    own: u32, // 124; a number of the host's
}
`,"normal_maps.wgsl":`// The mapped normal of a hit: spec/RNA.md, 4.5 Normal maps. The host declares
//     fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f
// which gives the two numbers from 0 to 255 of a texel.

// x and y of a map of \`size\` (columns, rows) at uv; it repeats.
fn rna_map_value(map: u32, size: vec2<u32>, uv: vec2f) -> vec2f {
    let at = uv * vec2f(size) - 0.5;
    let low = floor(at);
    let part = at - low;
    let sides = vec2<i32>(size);
    let first = ((vec2<i32>(low) % sides) + sides) % sides;
    let i = vec2<u32>(first);
    let j = vec2<u32>((first + 1) % sides);
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
    let x = vec2<u32>(t.low.x, t.high.x);
    let y = vec2<u32>(t.low.y, t.high.y);
    let z = vec2<u32>(t.low.z, t.high.z);
    return rna_bilinear(0u, group, x, y, t.fraction.x, t.fraction.y)
        + rna_bilinear(1u, group, y, z, t.fraction.y, t.fraction.z)
        + rna_bilinear(2u, group, z, x, t.fraction.z, t.fraction.x);
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
fn given_tangent(record: vec4<u32>, b: vec3f) -> vec4f {
    let base = surface_tangents(record.w >> 1u);
    if base == NONE {
        return vec4f(0.0);
    }
    let first = point_tangent(base, record.x);
    let second = point_tangent(base, record.y);
    let third = point_tangent(base, record.z);
    let all_there = first.w != 0.0 && second.w != 0.0 && third.w != 0.0;
    let t = b.x * first.xyz + b.y * second.xyz + b.z * third.xyz;
    return vec4f(t, select(0.0, first.w, all_there));
}

// The direction of u on the triangle, and the sign that makes the bitangent go against v.
fn derived_tangent(record: vec4<u32>, uv: mat3x2f, n: vec3f) -> vec4f {
    let p = rna_points[record.x].xyz;
    let e1 = rna_points[record.y].xyz - p;
    let e2 = rna_points[record.z].xyz - p;
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
fn kept_above(m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let mirror = 2.0 * dot(m, o) * m - o;
    let missing = min(0.9 * dot(g, o), MIN_MIRROR_COSINE) - dot(g, mirror);
    if missing <= 0.0 {
        return m;
    }
    return unit_or_zero(o + unit_or_zero(mirror + missing * g));
}

// The normal m with the relief of its material's normal texture; g, o: geometric normal and unit
// direction to the viewer.
fn bumped_normal(record: vec4<u32>, b1: f32, b2: f32, m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let texture = surface_textures(record.w >> 1u, RELIEF);
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
    let scale = surface_normal_scale(record.w >> 1u);
    let relief = 2.0 * texture_value(texture, uvs * b) - 1.0;
    let bitangent = tangent.w * cross(m, t);
    let bent = unit_or_zero(relief.z * m + scale * (relief.x * t + relief.y * bitangent));
    // All on the side of the surface that o is on, and back.
    let side = select(1.0, -1.0, dot(g, o) < 0.0);
    let own = select(-side, side, dot(m, g) >= 0.0);
    return own * kept_above(own * bent, side * g, o);
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

fn look_up_image(light: u32, d: vec3f) -> Met {
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
    return Met(light_colour(light) * radiance, pdf);
}
`,"render/frame.wgsl":`// What all steps of the renderer share: the step's numbers, paths, sums, and tables.

const IS_LIGHT: u32 = 0x80000000u; // with a light's number, in place of an instance
const PI: f32 = 3.14159265358979;
const SHORTER: f32 = 1.0 - 0x1p-13f; // shadow rays end before the light

const DEAD: u32 = 0u;
const ALIVE: u32 = 1u;

// A path has two queries: what its point sends on, and what an asset emits that its point samples as
// a light.
const ADDS: u32 = 0xfffffffeu; // parts, beside NONE: no decoder is asked what is sent on
const CATCHES_IT: u32 = 0xfffffffdu; // a shadow catcher

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> pendings: array<Pending>;
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

// Not above the clamp where light left more than one thing.
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
fn with_lights(ray: RnaRay, met: RnaHit) -> RnaHit {
    var hit = met;
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
`,"render/lights.wgsl":`// Lights: samples of them, and what rays that meet them find. They are those of rna_render.lights.

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

struct Met {
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

fn point_light(light: u32, x: vec3f) -> LightSample {
    let way = point_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let wi = way / r;
    let cosine = -dot(wi, point_axis(light));
    let inner = point_cos_inner(light);
    let outer = point_cos_outer(light);
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
        return point_light(light, x);
    }
    let way = shape_point(light, x, u);
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, colour, shape_pdf(light, x, way / r));
}

// What a ray along d that leaves the scene finds.
fn escaped(light: u32, d: vec3f) -> Met {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return look_up_image(light, d);
    }
    if kind == UNIFORM {
        return Met(colour, SPHERE_PDF);
    }
    if kind == SUN {
        let off = d - sun_axis(light);
        let cone = sun_one_minus_cosine(light);
        if dot(off, off) <= 2.0 * cone {
            return Met(colour, 1.0 / (2.0 * PI * cone));
        }
    }
    return Met(vec3f(0.0), 0.0);
}

// Where a ray meets the plane of a flat light; RNA_FAR where it is along it.
fn meet_plane(f: mat4x3f, ray: RnaRay) -> f32 {
    let down = dot(ray.direction, f[2]);
    if abs(down) < 1e-20 {
        return RNA_FAR;
    }
    return dot(f[3] - ray.origin, f[2]) / down;
}

// The ray's place there, along the light's axes.
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

// In [0, 1), the same for a primitive whenever this ray asks.
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
    if !surface_has(record.w >> 1u, LETS_THROUGH) {
        return passing != WEIGH;
    }
    let p = rna_points[record.x].xyz;
    let ng = cross(rna_points[record.y].xyz - p, rna_points[record.z].xyz - p);
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

struct Frame { // 144 bytes
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
    table_size: u32, // 112; of albedo
    things: u32, // 116; this and the rest: places of the sections of \`table\`
    surfaces: u32, // 120
    lights: u32, // 124
    albedo: u32, // 128
    domains: u32, // 132
    textures: u32, // 136
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

struct Pending { // 96 bytes
    x: vec3f, // 0
    h: f32, // 12
    axis: vec3f, // 16
    part: u32, // 28; or NONE, ADDS, CATCHES_IT
    wo: vec3f, // 32
    light: u32, // 44
    wi: vec3f, // 48
    strand: u32, // 60; that a ray from here passes through
    weight: vec3f, // 64
    seen: f32, // 76; mean of what all that is in the way leaves of the light
    visible: vec3f, // 80; what the asset itself leaves of it
    reserved: u32, // 92
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

fn corner_uvs(record: vec4<u32>, uv_set: u32) -> mat3x2f {
    let surface = record.w >> 1u;
    return mat3x2f(
        corner_uv(surface, record.x, uv_set),
        corner_uv(surface, record.y, uv_set),
        corner_uv(surface, record.z, uv_set),
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
const SUN: u32 = 1u;
const POINT: u32 = 2u;
const RECTANGLE: u32 = 3u;
const DISK: u32 = 4u;
const SPHERE: u32 = 5u;
const UNIFORM: u32 = 6u;
const IMAGE: u32 = 7u;
const TRIANGLES: u32 = 8u;

fn thing_number(k: u32) -> f32 {
    return table[frame.things + 1u * k + 0u].x;
}
fn thing_catches(k: u32) -> u32 {
    return bitcast<u32>(table[frame.things + 1u * k + 0u].y);
}
fn thing_step(k: u32) -> f32 {
    return table[frame.things + 1u * k + 0u].z;
}
fn thing_passes(k: u32) -> u32 {
    return bitcast<u32>(table[frame.things + 1u * k + 0u].w);
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
fn sun_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sun_one_minus_cosine(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn point_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn point_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 6u), light_numbers(k, 7u), light_numbers(k, 8u));
}
fn point_cos_inner(k: u32) -> f32 {
    return light_numbers(k, 9u);
}
fn point_cos_outer(k: u32) -> f32 {
    return light_numbers(k, 10u);
}
fn rectangle_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn rectangle_half(k: u32) -> vec2f {
    return vec2f(light_numbers(k, 15u), light_numbers(k, 16u));
}
fn disk_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn disk_radius(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn sphere_centre(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sphere_radius(k: u32) -> f32 {
    return light_numbers(k, 6u);
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
fn texture_on(texture: u32, record: vec4<u32>, b1: f32, b2: f32) -> vec3f {
    let uv_set = (image_of(texture).form >> 5u) & 1u;
    return texture_value(texture, corner_uvs(record, uv_set) * weights_of(b1, b2));
}

// A texture of the triangle's material; 1 where it has none.
fn factor_on(k: u32, record: vec4<u32>, b1: f32, b2: f32) -> vec3f {
    let texture = surface_textures(record.w >> 1u, k);
    if texture == NONE {
        return vec3f(1.0);
    }
    return texture_on(texture, record, b1, b2);
}

// Radiance that a material emits, to both sides.
fn emission_on(record: vec4<u32>, b1: f32, b2: f32) -> vec3f {
    return surface_emission(record.w >> 1u) * factor_on(GLOW, record, b1, b2);
}
`,"render/tracing.wgsl":`// Rays of the three sorts through the whole scene. light_shapes.wgsl adds lights with a shape, or a host says
//     fn with_lights(ray: RnaRay, met: RnaHit) -> RnaHit
// where there are none.

struct Through {
    hit: RnaHit,
    weight: vec3f, // for what the ray passed or met at random, if that has a colour
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
            && (rna_primitives[hit.primitive].w & 1u) == 0u;
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
fn kept_on(ray: RnaRay, own: u32) -> vec3f {
    start_passing(WEAKEN);
    var hit = rna_trace(ray, own, frame.rays, true);
    if hit.instance == RNA_NOTHING {
        hit = with_lights(ray, hit);
    }
    return select(vec3f(0.0), passed_weight, hit.instance == RNA_NOTHING);
}

// What an asset leaves of light along a ray from itself, in its object space.
fn own_kept(instance: u32, ray: RnaRay, strand: u32) -> vec3f {
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
    record: vec4<u32>, b: vec3f, d: vec3f, facing: bool,
) -> f32 {
    let surface = record.w >> 1u;
    let ior = surface_ior(surface);
    let eta = select(ior.y, ior.x, facing);
    let schlick = surface_has(surface, HAS_SCHLICK);
    if eta == 0.0 && !schlick {
        return 1.0;
    }
    let n = mat3x3f(normals[record.x].xyz, normals[record.y].xyz, normals[record.z].xyz) * b;
    let cosine = min(abs(dot(n, d)) / max(sqrt(dot(n, n) * dot(d, d)), 1e-30), 1.0);
    if eta != 0.0 {
        return 1.0 - dielectric_reflectance(eta, cosine);
    }
    let f0 = surface_f0(surface);
    let away = 1.0 - cosine;
    return (1.0 - f0) * (1.0 - away * away * away * away * away);
}

// Of a triangle, for a ray along d in object space. facing: it meets the normal's side.
fn transmittance(record: vec4<u32>, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    let surface = record.w >> 1u;
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
`,"render/triangle_lights.wgsl":`// Triangles that shine, of an object or an asset: rna_render/lights/mesh.py. In \`images\` a light has
// running sums of its triangles' shares (count + 1), their primitives (count), and densities per area
// by primitive of the body.

// Of points on either side of a triangle, seen from x along d, in object space.
fn triangle_pdf(light: u32, primitive: u32, x: vec3f, d: vec3f) -> f32 {
    let per_area = bitcast<f32>(images[triangles_densities(light) + primitive]);
    let record = rna_primitives[primitive];
    let p = rna_points[record.x].xyz;
    let area = cross(rna_points[record.y].xyz - p, rna_points[record.z].xyz - p);
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
    let p = rna_points[record.x].xyz;
    let way = p - x + b.x * (rna_points[record.y].xyz - p) + b.y * (rna_points[record.z].xyz - p);
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
    axis: vec3f, // what a decoder is asked with: mapped normal or tangent
    strand: u32,
    wo: vec3f,
    instance: u32,
    x_world: vec3f,
    shading: vec3f, // mapped normal of meshes, n of strands
    n_world: vec3f, // the same
    b1: f32,
    ng_world: vec3f,
    b2: f32,
    record: vec4<u32>, // of its primitive
}

// Of a normal map: a u32 a texel, whose first two bytes are its numbers.
fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f {
    let at = image_of(map);
    let word = images[at.place + row * at.size.x + column];
    return vec2f(f32(word & 255u), f32((word >> 8u) & 255u));
}

fn triangle_vertex(record: vec4<u32>, b1: f32, b2: f32) -> Vertex {
    var v: Vertex;
    let b = weights_of(b1, b2);
    let p = mat3x3f(
        rna_points[record.x].xyz, rna_points[record.y].xyz, rna_points[record.z].xyz,
    );
    let n = mat3x3f(normals[record.x].xyz, normals[record.y].xyz, normals[record.z].xyz);
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
    let map = surface_normal_map(record.w >> 1u);
    if map != NONE {
        v.shading = rna_mapped_normal(map, image_of(map).size, v.n, p, corner_uvs(record, 0u), b);
    }
    v.axis = v.shading;
    v.strand = RNA_NOTHING;
    return v;
}

fn segment_vertex(path: Path, record: vec4<u32>, wo: vec3f) -> Vertex {
    var v: Vertex;
    let cone = rna_cone(record.x);
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
    v.strand = record.z;
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
    if (record.w & 1u) == 0u {
        v = triangle_vertex(record, path.b1, path.b2);
    } else {
        v = segment_vertex(path, record, wo);
    }
    v.record = record;
    v.surface = record.w >> 1u;
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
    let step = thing_step(v.instance);
    return v.x_world + select(step, -step, dot(v.ng_world, wi_world) < 0.0) * v.ng_world;
}

// Where the ray along wi starts that asks whether the asset itself is in the way; object space.
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
fn rna_in_neighbour(segment: vec4<u32>, p: vec3f) -> bool {
    if (segment.y & 1u) != 0u {
        let before = rna_cone(segment.x - 1u);
        if rna_cone_distance(before, p) < -1e-4 * min(before.ra, before.rb) {
            return true;
        }
    }
    if (segment.y & 2u) != 0u {
        let after = rna_cone(segment.x + 1u);
        return rna_cone_distance(after, p) < -1e-4 * min(after.ra, after.rb);
    }
    return false;
}

// t of RNA_FAR for a miss.
fn rna_meet_segment(ray: RnaRay, segment: vec4<u32>) -> RnaEntry {
    let miss = RnaEntry(RNA_FAR, vec3f(0.0));
    let cone = rna_cone(segment.x);
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
    let features = rna_common_blocks(x, wo, wi);
    rna_surface_blocks(n, features, wo, wi);
    return rna_decode();
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_surface(x, axis, wo, wi);
}
`,"surface_blocks.wgsl":`// Input blocks of surfaces alone: spec/RNA.md, 6.3 Input blocks and "In float32".

// log2(1 - min(n.m, 1) + 1e-4) / 6
fn rna_log_gap(n: vec3f, m: vec3f) -> f32 {
    let gap = n - m;
    return log2(0.5 * dot(gap, gap) + 1e-4) / 6.0;
}

fn rna_half_vector(slot: u32, n: vec3f, m: vec3f, wo: vec3f, wi: vec3f) {
    if slot != RNA_NONE {
        rna_values[slot] = vec4f(dot(n, m), rna_log_gap(n, m), dot(n, wi), dot(n, wo));
        rna_values[slot + 1u] = vec4f(dot(wi, m), 0.0, 0.0, 0.0);
    }
}

fn rna_highlight(slot: u32, n: vec3f, m: vec3f) {
    let aside = cross(n, m);
    rna_put(slot, vec4f(log2(dot(aside, aside) + 1e-8) / 12.0, 0.0, 0.0, 0.0));
}

fn rna_learned_normal(slot: u32, n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
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
    let m = rna_halfway(wo, wi, q);
    rna_values[slot] = vec4f(dot(q, m), rna_log_gap(q, m), 0.0, 0.0);
}

fn rna_surface_blocks(n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_NORMAL), vec4f(n, 0.0));
    let m = rna_halfway(wo, wi, n);
    rna_half_vector(rna_slot(RNA_BLOCK_HALF_VECTOR), n, m, wo, wi);
    rna_highlight(rna_slot(RNA_BLOCK_HIGHLIGHT), n, m);
    rna_learned_normal(rna_slot(RNA_BLOCK_LEARNED_NORMAL), n, features, wo, wi);
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
    let above = dot(ng, wi);
    if dot(n, wi) > 0.0 && dot(n, ng) > 0.0 && above < 0.1 {
        return x + (1.0 - max(0.0, above) / 0.1) * lift + step * ng;
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
`};var Vt=`// What a band of the picture holds between the kernels, and what the viewer's kernels know beside rna_gpu's Frame.

struct View {
    first: u32,  // pixel of the band
    jitter: f32, // 0: rays through the middles of pixels, 1: anywhere in them
    kind: u32,   // of the light, see light.wgsl
    is_first: u32, // 1: the sum starts with this
    direction: vec3f, // of a sun
    counts_coverage: u32,
    colour: vec3f, // irradiance of a sun
    ground: f32,   // its height
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    middle: vec2f,        // of the ground, x and z
    part: u32,     // that is asked, + 1
    emission: u32, // 1: answers are of emission, one vec4f each
}

// A pixel: a row as rna_evaluate reads it, with two numbers in its free places; and what it weighs.
struct Pixel {
    position: vec4<u32>, // and h of a fiber
    axis: vec4<u32>,     // and part + 1, or 0 where nothing is hit
    wo: vec4<u32>,       // and the primitive
    wi: vec4<u32>,
    through: vec3f, // throughput
    b1: f32,        // barycentric coordinates
    radiance: vec3f, // over the density, times the throughput; of the ground what it sends on
    b2: f32,
    visibility: vec3f,
    coverage: f32, // of the ground
}

@group(1) @binding(0) var<storage, read_write> band: array<Pixel>;
@group(1) @binding(1) var<uniform> view: View;
`;var Ws=`// A ray from the camera through each pixel of the band, to the query of its first hit.

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

// There are no lights with a shape.
fn with_lights(ray: RnaRay, met: RnaHit) -> RnaHit {
    return met;
}

fn pixel_of(hit: RnaHit, wo: vec3f) -> Pixel {
    var pixel: Pixel;
    pixel.wo = words(wo, hit.primitive);
    if hit.instance == RNA_NOTHING {
        return pixel;
    }
    let record = rna_primitives[hit.primitive];
    var v: Vertex;
    if (record.w & 1u) == 0u {
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
    pixel.axis = words(v.axis, surface_part(record.w >> 1u) + 1u);
    pixel.b1 = hit.b1;
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
    let at = place + mix(vec2f(0.5), square(number, 0u, frame.sample), view.jitter);
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
`;var Ys=`// For each query a direction of one light, what arrives from there, and how much of it the asset lets through; and
// the light on the ground.

const OF_SUN = 0u; // kinds of view.kind
const BRIGHT = 1u; // the environment, where it is bright
const GIVEN = 2u;  // directions of the rows
const ABOUT = 3u;  // the environment, about the point

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
    if (rna_primitives[pixel.wo.w].w & 1u) != 0u {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(number: u32, pixel: Pixel) -> Arrival {
    if view.kind == OF_SUN {
        return Arrival(view.direction, view.colour);
    }
    if view.kind == GIVEN {
        return Arrival(bitcast<vec3f>(pixel.wi.xyz), view.colour);
    }
    let at = surroundings_of(pixel);
    if view.kind == BRIGHT {
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
    if (record.w & 1u) == 0u {
        v = triangle_vertex(record, pixel.b1, pixel.b2);
        v.kind = OF_NEURAL;
    } else {
        v.x = bitcast<vec3f>(pixel.position.xyz);
        v.kind = OF_FIBERS;
        v.strand = record.z;
    }
    return own_kept(0u, RnaRay(leaving_point(v, wi), 0.0, wi, RNA_FAR), v.strand);
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
    return vec4f(weight * own_kept(0u, way, RNA_NOTHING), fade);
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
`;var Lr=`// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

struct Row {
    position: vec4<u32>,
    axis: vec4<u32>,
    wo: vec4<u32>,
    wi: vec4<u32>,
}

@group(2) @binding(0) var<storage, read_write> asked: array<Row>;
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
    let wi = select(pixel.wi, pixel.wo, view.emission == 1u);
    asked[at] = Row(pixel.position, pixel.axis, pixel.wo, wi);
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
    if view.emission == 0u {
        radiance = pixel.radiance * mix(answers[2u * at + 1u].xyz, answers[2u * at].xyz, pixel.visibility);
    }
    sums[view.first + k] += vec4f(radiance, 0.0);
}
`;var Pr=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec3f, // linear light of the screen
    rounds: f32,
    exposure: f32,  // a factor
    filmic: f32,    // 1 for the filmic view transform, 0 for none
    spread: f32,    // of noise, in values of the screen; 0 to leave it
    unused: f32,
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    return sums[place.y * u32(shown.picture.x) + place.x];
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

// Values of the screen, sRGB, of a mean.
fn displayed(mean: vec4f) -> vec3f {
    let exposed = max(mean.xyz * shown.exposure, vec3f(0.0));
    let light = select(exposed, filmic(exposed), shown.filmic > 0.5);
    let linear = clamp(light, vec3f(0.0), vec3f(1.0)) + max(0.0, 1.0 - mean.w) * shown.backdrop;
    let encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3f(1.0 / 2.4)) - 0.055, step(vec3f(0.0031308), linear));
    return clamp(encoded, vec3f(0.0), vec3f(1.0));
}

@fragment
fn colour(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy * shown.picture / shown.size - 0.5;
    let low = floor(place);
    let f = place - low;
    let above = mix(picture_at(low.x, low.y), picture_at(low.x + 1.0, low.y), f.x);
    let below = mix(picture_at(low.x, low.y + 1.0), picture_at(low.x + 1.0, low.y + 1.0), f.x);
    let mean = mix(above, below, f.y) / shown.rounds;
    let here = displayed(mean);
    if (shown.spread == 0.0) {
        return vec4f(here, 1.0);
    }
    // Bilateral: neighbours count by how near and how like they are.
    var sum = vec4f(here, 1.0);
    let middle = round(place);
    for (var dy = -2.0; dy <= 2.0; dy += 1.0) {
        for (var dx = -2.0; dx <= 2.0; dx += 1.0) {
            let there = middle + vec2f(dx, dy);
            let other = picture_at(there.x, there.y) / shown.rounds;
            let value = displayed(other);
            let away = there - place;
            let unlike = (value - here) / shown.spread;
            let edge = 4.0 * (other.w - mean.w);
            sum += vec4f(value, 1.0) * exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
        }
    }
    return vec4f(sum.xyz / sum.w, 1.0);
}
`;var Vs=`// What segment.wgsl has, for assets without strands: code that an asset has no use for is not compiled, which takes
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

fn rna_meet_segment(ray: RnaRay, segment: vec4<u32>) -> RnaEntry {
    return RnaEntry(RNA_FAR, vec3f(0.0));
}
`;var Xs=`// What normal_maps.wgsl and render/transmittance.wgsl have, for assets without textures.

fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    return n;
}

fn transmittance(record: vec4<u32>, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    return vec3f(0.0);
}
`;for(let n of[Vt,Lr,Pr])Ai(n);var Ks=n=>n in At?[n]:Yt[n].flatMap(Ks),zn=(n,e=At)=>[...new Set(n.flatMap(Ks))].map(t=>e[t]).join(`
`);function Cn(n,...e){return Object.entries(n).map(([r,i])=>`const ${r}: u32 = ${i}u;
`).join("")+zn(e)}function Ln({hasSegments:n,hasTextures:e}){let t={...At};return n||(t["segment.wgsl"]=Vs),e||Object.assign(t,{"normal_maps.wgsl":Xs,"render/transmittance.wgsl":""}),{hit:zn(Yt.hit,t)+Vt+Ws,light:zn(Yt.light,t)+Vt+Ys}}var Dr={queue:zn(Yt.queue)+Vt+Lr,show:Pr};var Pn=class{constructor(e){this.device=e,this.made=new Map}get(e,t,r){let i=`${t}
${e}`;return this.made.has(i)||this.made.set(i,this._make(e,t,r)),this.made.get(i)}async _make(e,t,r){let i=await kn(this.device,e),s=r?this.device.createPipelineLayout({bindGroupLayouts:r}):"auto";return this.device.createComputePipelineAsync({layout:s,compute:{module:i,entryPoint:t}})}},Dn=class n{static async make(e,t,r,i,s,a){let c=new n,{weights:l,record:h,groups:p}=On(r,i,s),{UNIFORM_WEIGHTS:m}=ie,v=l.length/4<=m,b={RNA_GROUPS:p,RNA_COLOURS:i.outputs===6?2:1},S=v?"weights_uniform.wgsl":"weights_storage.wgsl";c.pipeline=await t.get(Cn(b,S,r.kind,"evaluate"),"rna_evaluate");let{UNIFORM:T,STORAGE:L}=GPUBufferUsage,Y=v?new Float32Array(4*m):l;return v&&Y.set(l),c.buffers=[ae(e,h,T,"a decoder"),ae(e,Y,v?T:L,"a decoder")],c.part=Gt(e,c.pipeline,0,[...c.buffers,...a]),c.device=e,c}run(e,{rows:t,answers:r,count:i},s){this.bound??=Gt(this.device,this.pipeline,1,[t,r,i]),Me(e,this.pipeline,[this.part,this.bound],s)}delete(){for(let e of this.buffers)e.destroy()}};var Xt=1<<17,Il={sun:0,environment:1,given:2,aroundPoint:3},Un=class n{static label="WebGPU";static async open(e){let t=new n,r=await _s();Object.assign(t,{canvas:e,device:r,parts:[],lost:!1,bandPixels:Xt}),r.lost.then(({reason:s,message:a})=>{t.lost=!0,t.closed||t.onlost?.(`the GPU was lost (${a||s})`)}),r.addEventListener("uncapturederror",({error:s})=>{t.error??=s}),t.context=e.getContext("webgpu");let i=navigator.gpu.getPreferredCanvasFormat();return t.context.configure({device:r,format:i,alphaMode:"opaque",usage:GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.COPY_SRC}),t.pipelines=new Pn(r),t.compiled=t._compile(i),t.compiled.catch(()=>{}),t}async _compile(e){let{device:t}=this,r=await kn(t,Dr.show),[i,s,a]=["uniform","storage","read-only-storage"],c=xt(t,{0:s,1:i});this.rayLayout=[xt(t,{0:i,4:a,5:a}),c,xt(t,{0:a,1:a,2:a,3:a,4:a})],this.queueLayout=[xt(t,{0:i,2:s}),c,xt(t,{0:s,1:s,2:s})];let[l,h,p,m]=await Promise.all([...["begin","gather","scatter"].map(v=>this.pipelines.get(Dr.queue,v,this.queueLayout)),t.createRenderPipelineAsync({layout:"auto",vertex:{module:r,entryPoint:"corner"},fragment:{module:r,entryPoint:"colour",targets:[{format:e}]}})]);Object.assign(this,{queueKernels:{begin:l,gather:h,scatter:p},shown:m}),this._makeBand()}_makeBand(){let{device:e}=this,{UNIFORM:t}=GPUBufferUsage;this.frameRecord=ae(e,fe("Frame",{}),t),this.viewRecord=ae(e,ft("View"),t),this.showRecord=ae(e,ft("Show"),t),this.band=ae(e,ft("Pixel")*Xt),this.queue={rows:ae(e,ft("Row")*Xt),answers:ae(e,32*Xt),count:ae(e,4*(Xt+4))},this._bind()}async setAsset(e,t){let{device:r,pipelines:i}=this;this._deleteAsset();let s=(m,v)=>ae(r,m,void 0,`the asset's ${v}`);this.geometry=[s(e.nodes,"hierarchy"),s(e.primitives,"geometry"),s(e.points,"geometry"),s(Ml(e.extent),"geometry"),s(e.normals,"geometry")],this.lightsAt=e.table.length/4,this.table=ae(r,4*e.table.length+ft("Light")),r.queue.writeBuffer(this.table,0,e.table),this.arrays=e,this._storeImages(),await this.compiled,this.raySources=Ln({hasSegments:e.strands>0,hasTextures:e.hasTextures});let{hit:a,light:c}=this.raySources,[l,h,...p]=await Promise.all([i.get(a,"trace_pixels",this.rayLayout),i.get(c,"light_pixels",this.rayLayout),...t.map(m=>this._makePart(m))]);this.parts=p,this.kernels={hit:l,light:h,...this.queueKernels},this._bind()}async _makePart(e){let{device:t,pipelines:r}=this,i=[0,1,2].map(c=>ae(t,In(e.planes,c),void 0,"a plane of features")),s=(c,l)=>Dn.make(t,r,e,c,l,i),a=await s(e.transport,e.inputs);return{planes:i,transport:a,emission:e.emission&&await s(e.emission,e.emission.inputs)}}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment(e){this.environment=e,this._storeImages(),this._bind()}_storeImages(){if(!this.geometry)return;let{images:e}=this.arrays,t=this.environment?.floats??new Float32Array(0);this.images?.destroy(),this.images=ae(this.device,4*(e.length+t.length),void 0,"the environment"),this.device.queue.writeBuffer(this.images,0,e),this.device.queue.writeBuffer(this.images,4*e.length,t)}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let r=e*t;(!this.sums||r>this.capacity||r*8<this.capacity)&&(this.sums?.destroy(),this.sums=ae(this.device,16*r,void 0,"the picture"),this.capacity=r,this._bind()),this.target={width:e,height:t}}_bind(){if(!this.geometry||!this.sums||!this.band||!this.kernels)return;let{device:e,rayLayout:t,queueLayout:r,queue:i}=this,s=nt(e,t[1],{0:this.band,1:this.viewRecord});this.groups={rays:[nt(e,t[0],{0:this.frameRecord,4:this.table,5:this.images}),s,nt(e,t[2],this.geometry)],queue:[nt(e,r[0],{0:this.frameRecord,2:this.sums}),s,nt(e,r[2],[i.rows,i.answers,i.count])],show:Gt(e,this.shown,0,[this.showRecord,this.sums])}}trace(e,t,r,i){let{width:s}=this.target;this.span={first:r*s,pixels:(i-r)*s,jitter:e.jitter??1},this._writeFrame(e,t),this._writeView({}),this._run(a=>Me(a,this.kernels.hit,this.groups.rays,this.span.pixels))}light(e,{isFirst:t,countsCoverage:r}){this._writeLight(e),this.view={...e,isFirst:t,countsCoverage:r},this._writeView(this.view),this._run(i=>{Me(i,this.kernels.light,this.groups.rays,this.span.pixels),Me(i,this.kernels.begin,this.groups.queue,this.span.pixels)}),this._decode("transport")}emission(){this._decode("emission")}show({rounds:e,exposure:t,backdrop:r,filmic:i,spread:s}){let{width:a,height:c}=this.target,{canvas:l,device:h}=this;h.queue.writeBuffer(this.showRecord,0,fe("Show",{size:[l.width,l.height],picture:[a,c],backdrop:r,rounds:e,exposure:t,filmic:Number(i),spread:s}));let p=h.createCommandEncoder(),m=this.context.getCurrentTexture().createView(),v=p.beginRenderPass({colorAttachments:[{view:m,loadOp:"clear",storeOp:"store"}]});v.setPipeline(this.shown),v.setBindGroup(0,this.groups.show),v.draw(3),v.end(),h.queue.submit([p.finish()])}async done(){if(await this.device.queue.onSubmittedWorkDone(),this.error)throw this.error}async picture(){let{width:e,height:t}=this.target;return new Float32Array(await qt(this.device,this.sums,16*e*t))}_decode(e){for(let[t,r]of this.parts.entries()){let i=r[e];i&&(this._writeView({...this.view,part:t+1,isEmission:e==="emission"}),this.device.queue.writeBuffer(this.queue.count,0,Uint32Array.of(0)),this._run(s=>{Me(s,this.kernels.gather,this.groups.queue,this.span.pixels),i.run(s,this.queue,this.span.pixels),Me(s,this.kernels.scatter,this.groups.queue,this.span.pixels)}))}}_run(e){let t=this.device.createCommandEncoder(),r=t.beginComputePass();e(r),r.end(),this.device.queue.submit([t.finish()])}_writeFrame({position:e,corner:t,stepX:r,stepY:i},s){let{lightsAt:a,arrays:c,span:l,target:h}=this;this.device.queue.writeBuffer(this.frameRecord,0,fe("Frame",{camera:e,corner:t,step_x:r,step_y:i,width:h.width,paths:l.pixels,sample:s,branches:1,depth:1,rays:ie.CAMERA_RAY,flags:c.transmits?ie.TRANSMITS:0,textures:c.texturesAt,lights:a}))}_writeView({kind:e="sun",direction:t=[0,0,0],colour:r=[0,0,0],ground:i,isFirst:s=!1,countsCoverage:a=!1,part:c=0,isEmission:l=!1}){let{first:h,jitter:p}=this.span,m=i&&{ground:i.height,ground_colour:i.colour,ground_size:i.size,middle:[i.x,i.z]};this.device.queue.writeBuffer(this.viewRecord,0,fe("View",{first:h,jitter:p,kind:Il[e],is_first:Number(s),direction:t,counts_coverage:Number(a),colour:r,part:c,emission:Number(l),...m}))}_writeLight({angle:e,colour:t}){if(e===void 0)return;let{width:r,height:i,total:s,places:a}=this.environment,c={turn_cosine:Math.cos(e),turn_sine:Math.sin(e)},l=Ei("image",{colour:t,...c,total:s,rows:i,columns:r});this.device.queue.writeBuffer(this.table,16*this.lightsAt,fe("Light",{kind:ie.IMAGE,group:ie.NONE,numbers:l,places:a.map(h=>h+this.arrays.images.length)}))}_deleteAsset(){for(let e of[...this.geometry??[],this.table,this.images])e?.destroy();for(let{planes:e,transport:t,emission:r}of this.parts)e.forEach(i=>i.destroy()),t.delete(),r?.delete();this.parts=[],this.geometry=this.images=null}close(){this.closed=!0,this._deleteAsset(),this.device.destroy()}},Ml=n=>fe("RnaInstance",{to_object:[1,0,0,0,0,1,0,0,0,0,1,0],rotation:[1,0,0,0,0,1,0,0,0,0,1,0],scale:1,root:1,rays:ie.CAMERA_RAY,extent:n});var Fl={webgpu:Un,webgl2:Fn};async function Js(n,e){let t=[];for(let[r,i]of Object.entries(Fl))if(!(e&&e!==r))try{let s=n();return{engine:await i.open(s),canvas:s,reasons:t}}catch(s){t.push(s.message)}throw new B(`this browser shows the poster alone: ${t.join("; ")||`no engine ${e}`}`)}var Qs=[1024,512];function eo(n){let{rgb:e,width:t,height:r}=Ll(n),i=[0,e.length,e.length+r+1,e.length+2*r+3],s=new Float32Array(i[3]+(r+1)*(t+1));s.set(e);let a=l=>Math.cos(Math.PI*Math.min(1,Math.max(0,(l-.5)/r))),c=0;for(let l=0;l<=r;l++){let h=a(l)-a(l+1),p=t*Math.max(l-1,0),m=t*Math.min(l,r-1);s[i[1]+l]=h;let v=0;for(let b=0;b<t;b++){let S=(b+1)%t,T=[p+b,p+S,m+b,m+S].reduce((L,Y)=>L+zl(e,Y),0);v+=T/4*h,s[i[3]+l*(t+1)+b+1]=v}c+=v,s[i[2]+l+1]=c}return{floats:s,places:i,total:c,width:t,height:r,up:Cl(e,t,r)}}var zl=(n,e)=>.2126*n[3*e]+.7152*n[3*e+1]+.0722*n[3*e+2];function Cl(n,e,t){let r=[0,0,0];for(let i=0;i<t;i++){let s=Math.PI*(i+.5)/t,a=2*Math.PI**2*Math.sin(s)/(e*t)*Math.max(0,Math.cos(s));for(let c=0;c<3*e;c++)r[c%3]+=n[3*e*i+c]*a}return r}function Ll({rgb:n,width:e,height:t}){let r=Math.max(1,Math.ceil(e/Qs[0]),Math.ceil(t/Qs[1]));if(r===1)return{rgb:n,width:e,height:t};let i=Math.ceil(e/r),s=Math.ceil(t/r),a=new Float32Array(3*i*s);for(let c=0;c<s;c++)for(let l=0;l<i;l++){let h=0;for(let p=c*r;p<Math.min(t,(c+1)*r);p++)for(let m=l*r;m<Math.min(e,(l+1)*r);m++,h++)for(let v=0;v<3;v++)a[3*(c*i+l)+v]+=n[3*(p*e+m)+v];for(let p=0;p<3;p++)a[3*(c*i+l)+p]/=h}return{rgb:a,width:i,height:s}}function Bn(n){return{rgb:Float32Array.from({length:96},(r,i)=>n[i%3]),width:8,height:4}}function to(){let t=new Float32Array(24576),r=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let i=0;i<64;i++){let s=Math.PI*(i+.5)/64;for(let a=0;a<128;a++){let c=2*Math.PI*((a+.5)/128-.5),l=[Math.sin(s)*Math.sin(c),Math.cos(s),-Math.sin(s)*Math.cos(c)],h=.16+.14*Math.max(0,l[1]);for(let p=0;p<3;p++){let m=h*[.95,1,1.08][p];for(let[v,b,S]of r){let T=(l[0]*v[0]+l[1]*v[1]+l[2]*v[2])/Math.hypot(...v);m+=S[p]*Math.min(1,Math.max(0,(T-b)/.03))}t[3*(i*128+a)+p]=m}}}return{rgb:t,width:128,height:64}}var Ur=0,Br=1,$r=2,Hr=3,Gr=4,qr=5,Zr=6,jr=7;var Wr=1006;var Et=1015,Rt=1016;var Ve=1023;var Kt=1028;var kt=1030;var Xe="srgb-linear";var no=null;function Pl(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ro(...n){n=Pl(n);let e="THREE."+n.shift();if(no)no("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}var Qp={[Ur]:Ur,[$r]:Zr,[Gr]:Gr,[Hr]:qr,[Br]:Br,[Zr]:$r,[jr]:jr,[qr]:Hr};var tm=Math.PI/180,nm=180/Math.PI;function io(n,e,t){return Math.max(e,Math.min(t,n))}var Ue=Dl();function Dl(){let n=new ArrayBuffer(4),e=new Float32Array(n),t=new Uint32Array(n),r=new Uint32Array(512),i=new Uint32Array(512);for(let l=0;l<256;++l){let h=l-127;h<-27?(r[l]=0,r[l|256]=32768,i[l]=24,i[l|256]=24):h<-14?(r[l]=1024>>-h-14,r[l|256]=1024>>-h-14|32768,i[l]=-h-1,i[l|256]=-h-1):h<=15?(r[l]=h+15<<10,r[l|256]=h+15<<10|32768,i[l]=13,i[l|256]=13):h<128?(r[l]=31744,r[l|256]=64512,i[l]=24,i[l|256]=24):(r[l]=31744,r[l|256]=64512,i[l]=13,i[l|256]=13)}let s=new Uint32Array(2048),a=new Uint32Array(64),c=new Uint32Array(64);for(let l=1;l<1024;++l){let h=l<<13,p=0;for(;(h&8388608)===0;)h<<=1,p-=8388608;h&=-8388609,p+=947912704,s[l]=h|p}for(let l=1024;l<2048;++l)s[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)a[l]=l<<23;a[31]=1199570944,a[32]=2147483648;for(let l=33;l<63;++l)a[l]=2147483648+(l-32<<23);a[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(c[l]=1024);return{floatView:e,uint32View:t,baseTable:r,shiftTable:i,mantissaTable:s,exponentTable:a,offsetTable:c}}function Ul(n){Math.abs(n)>65504&&ro("DataUtils.toHalfFloat(): Value out of range."),n=io(n,-65504,65504),Ue.floatView[0]=n;let e=Ue.uint32View[0],t=e>>23&511;return Ue.baseTable[t]+((e&8388607)>>Ue.shiftTable[t])}function Bl(n){let e=n>>10;return Ue.uint32View[0]=Ue.mantissaTable[Ue.offsetTable[e]+(n&1023)]+Ue.exponentTable[e],Ue.floatView[0]}var I=class{static toHalfFloat(e){return Ul(e)}static fromHalfFloat(e){return Bl(e)}};var $n=class{};var ye=Uint8Array,St=Uint16Array,$l=Int32Array,so=new ye([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),oo=new ye([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Hl=new ye([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ao=function(n,e){for(var t=new St(31),r=0;r<31;++r)t[r]=e+=1<<n[r-1];for(var i=new $l(t[30]),r=1;r<30;++r)for(var s=t[r];s<t[r+1];++s)i[s]=s-t[r]<<5|r;return{b:t,r:i}},co=ao(so,2),lo=co.b,Gl=co.r;lo[28]=258,Gl[258]=28;var uo=ao(oo,0),ql=uo.b,um=uo.r,Xr=new St(32768);for(W=0;W<32768;++W)Be=(W&43690)>>1|(W&21845)<<1,Be=(Be&52428)>>2|(Be&13107)<<2,Be=(Be&61680)>>4|(Be&3855)<<4,Xr[W]=((Be&65280)>>8|(Be&255)<<8)>>1;var Be,W,Jt=(function(n,e,t){for(var r=n.length,i=0,s=new St(e);i<r;++i)n[i]&&++s[n[i]-1];var a=new St(e);for(i=1;i<e;++i)a[i]=a[i-1]+s[i-1]<<1;var c;if(t){c=new St(1<<e);var l=15-e;for(i=0;i<r;++i)if(n[i])for(var h=i<<4|n[i],p=e-n[i],m=a[n[i]-1]++<<p,v=m|(1<<p)-1;m<=v;++m)c[Xr[m]>>l]=h}else for(c=new St(r),i=0;i<r;++i)n[i]&&(c[i]=Xr[a[n[i]-1]++]>>15-n[i]);return c}),Qt=new ye(288);for(W=0;W<144;++W)Qt[W]=8;var W;for(W=144;W<256;++W)Qt[W]=9;var W;for(W=256;W<280;++W)Qt[W]=7;var W;for(W=280;W<288;++W)Qt[W]=8;var W,fo=new ye(32);for(W=0;W<32;++W)fo[W]=5;var W;var Zl=Jt(Qt,9,1);var jl=Jt(fo,5,1),Yr=function(n){for(var e=n[0],t=1;t<n.length;++t)n[t]>e&&(e=n[t]);return e},Re=function(n,e,t){var r=e/8|0;return(n[r]|n[r+1]<<8)>>(e&7)&t},Vr=function(n,e){var t=e/8|0;return(n[t]|n[t+1]<<8|n[t+2]<<16)>>(e&7)},Wl=function(n){return(n+7)/8|0},Yl=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.length),new ye(n.subarray(e,t))};var Vl=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],ke=function(n,e,t){var r=new Error(e||Vl[n]);if(r.code=n,Error.captureStackTrace&&Error.captureStackTrace(r,ke),!t)throw r;return r},Xl=function(n,e,t,r){var i=n.length,s=r?r.length:0;if(!i||e.f&&!e.l)return t||new ye(0);var a=!t,c=a||e.i!=2,l=e.i;a&&(t=new ye(i*3));var h=function(on){var an=t.length;if(on>an){var Mt=new ye(Math.max(an*2,on));Mt.set(t),t=Mt}},p=e.f||0,m=e.p||0,v=e.b||0,b=e.l,S=e.d,T=e.m,L=e.n,Y=i*8;do{if(!b){p=Re(n,m,1);var ee=Re(n,m+1,3);if(m+=3,ee)if(ee==1)b=Zl,S=jl,T=9,L=5;else if(ee==2){var it=Re(n,m,31)+257,$e=Re(n,m+10,15)+4,nr=it+Re(n,m+5,31)+1;m+=14;for(var Ke=new ye(nr),Ce=new ye(19),re=0;re<$e;++re)Ce[Hl[re]]=Re(n,m+re*3,7);m+=$e*3;for(var nn=Yr(Ce),rr=(1<<nn)-1,_e=Jt(Ce,nn,1),re=0;re<nr;){var It=_e[Re(n,m,rr)];m+=It&15;var J=It>>4;if(J<16)Ke[re++]=J;else{var me=0,st=0;for(J==16?(st=3+Re(n,m,3),m+=2,me=Ke[re-1]):J==17?(st=3+Re(n,m,7),m+=3):J==18&&(st=11+Re(n,m,127),m+=7);st--;)Ke[re++]=me}}var rn=Ke.subarray(0,it),xe=Ke.subarray(it);T=Yr(rn),L=Yr(xe),b=Jt(rn,T,1),S=Jt(xe,L,1)}else ke(1);else{var J=Wl(m)+4,ce=n[J-4]|n[J-3]<<8,rt=J+ce;if(rt>i){l&&ke(0);break}c&&h(v+ce),t.set(n.subarray(J,rt),v),e.b=v+=ce,e.p=m=rt*8,e.f=p;continue}if(m>Y){l&&ke(0);break}}c&&h(v+131072);for(var sn=(1<<T)-1,ir=(1<<L)-1,de=m;;de=m){var me=b[Vr(n,m)&sn],Se=me>>4;if(m+=me&15,m>Y){l&&ke(0);break}if(me||ke(2),Se<256)t[v++]=Se;else if(Se==256){de=m,b=null;break}else{var be=Se-254;if(Se>264){var re=Se-257,Le=so[re];be=Re(n,m,(1<<Le)-1)+lo[re],m+=Le}var Je=S[Vr(n,m)&ir],ot=Je>>4;Je||ke(3),m+=Je&15;var xe=ql[ot];if(ot>3){var Le=oo[ot];xe+=Vr(n,m)&(1<<Le)-1,m+=Le}if(m>Y){l&&ke(0);break}c&&h(v+131072);var X=v+be;if(v<xe){var Pe=s-xe,He=Math.min(xe,X);for(Pe+v<0&&ke(3);v<He;++v)t[v]=r[Pe+v]}for(;v<X;++v)t[v]=t[v-xe]}}e.l=b,e.p=de,e.b=v,e.f=p,b&&(p=1,e.m=T,e.d=S,e.n=L)}while(!p);return v!=t.length&&a?Yl(t,0,v):t.subarray(0,v)};var Kl=new ye(0);var Jl=function(n,e){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&ke(6,"invalid zlib data"),(n[1]>>5&1)==+!e&&ke(6,"invalid zlib data: "+(n[1]&32?"need":"unexpected")+" dictionary"),(n[1]>>3&4)+2};function Tt(n,e){return Xl(n.subarray(Jl(n,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Ql=typeof TextDecoder<"u"&&new TextDecoder,eu=0;try{Ql.decode(Kl,{stream:!0}),eu=1}catch{}var Hn=class extends $n{constructor(e){super(e),this.type=Rt,this.outputFormat=Ve,this.part=0}parse(e){let Ke=Math.pow(2.7182818,2.2),Ce=null,re=null;function nn(o,u){let f=0;for(let w=0;w<65536;++w)(w==0||o[w>>3]&1<<(w&7))&&(u[f++]=w);let g=f-1;for(;f<65536;)u[f++]=0;return g}function rr(o){for(let u=0;u<16384;u++)o[u]={},o[u].len=0,o[u].lit=0,o[u].p=null}let _e={l:0,c:0,lc:0};function It(o,u,f,g,w){for(;f<o;)u=u<<8|fi(g,w),f+=8;f-=o,_e.l=u>>f&(1<<o)-1,_e.c=u,_e.lc=f}let me=new Array(59);function st(o){for(let f=0;f<=58;++f)me[f]=0;for(let f=0;f<65537;++f)me[o[f]]+=1;let u=0;for(let f=58;f>0;--f){let g=u+me[f]>>1;me[f]=u,u=g}for(let f=0;f<65537;++f){let g=o[f];g>0&&(o[f]=g|me[g]++<<6)}}function rn(o,u,f,g,w,x){let d=u,E=0,_=0;for(;g<=w;g++){if(d.value-u.value>f)return!1;It(6,E,_,o,d);let A=_e.l;if(E=_e.c,_=_e.lc,x[g]=A,A==63){if(d.value-u.value>f)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");It(8,E,_,o,d);let R=_e.l+6;if(E=_e.c,_=_e.lc,g+R>w+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;R--;)x[g++]=0;g--}else if(A>=59){let R=A-59+2;if(g+R>w+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;R--;)x[g++]=0;g--}}st(x)}function xe(o){return o&63}function sn(o){return o>>6}function ir(o,u,f,g){for(;u<=f;u++){let w=sn(o[u]),x=xe(o[u]);if(w>>x)throw new Error("THREE.EXRLoader: Invalid table entry");if(x>14){let d=g[w>>x-14];if(d.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(d.lit++,d.p){let E=d.p;d.p=new Array(d.lit);for(let _=0;_<d.lit-1;++_)d.p[_]=E[_]}else d.p=new Array(1);d.p[d.lit-1]=u}else if(x){let d=0;for(let E=1<<14-x;E>0;E--){let _=g[(w<<14-x)+d];if(_.len||_.p)throw new Error("THREE.EXRLoader: Invalid table entry");_.len=x,_.lit=u,d++}}}return!0}let de={c:0,lc:0};function Se(o,u,f,g){o=o<<8|fi(f,g),u+=8,de.c=o,de.lc=u}let be={c:0,lc:0};function Le(o,u,f,g,w,x,d,E,_){if(o==u){g<8&&(Se(f,g,w,x),f=de.c,g=de.lc),g-=8;let A=f>>g;if(A=new Uint8Array([A])[0],E.value+A>_)return!1;let R=d[E.value-1];for(;A-- >0;)d[E.value++]=R}else if(E.value<_)d[E.value++]=o;else return!1;be.c=f,be.lc=g}function Je(o){return o&65535}function ot(o){let u=Je(o);return u>32767?u-65536:u}let X={a:0,b:0};function Pe(o,u){let f=ot(o),w=ot(u),x=f+(w&1)+(w>>1),d=x,E=x-w;X.a=d,X.b=E}function He(o,u){let f=Je(o),g=Je(u),w=f-(g>>1)&65535,x=g+w-32768&65535;X.a=x,X.b=w}function on(o,u,f,g,w,x,d){let E=d<16384,_=f>w?w:f,A=1,R,N;for(;A<=_;)A<<=1;for(A>>=1,R=A,A>>=1;A>=1;){N=0;let k=N+x*(w-R),M=x*A,z=x*R,O=g*A,F=g*R,U,G,$,Z;for(;N<=k;N+=z){let P=N,C=N+g*(f-R);for(;P<=C;P+=F){let D=P+O,V=P+M,j=V+O;E?(Pe(o[P+u],o[V+u]),U=X.a,$=X.b,Pe(o[D+u],o[j+u]),G=X.a,Z=X.b,Pe(U,G),o[P+u]=X.a,o[D+u]=X.b,Pe($,Z),o[V+u]=X.a,o[j+u]=X.b):(He(o[P+u],o[V+u]),U=X.a,$=X.b,He(o[D+u],o[j+u]),G=X.a,Z=X.b,He(U,G),o[P+u]=X.a,o[D+u]=X.b,He($,Z),o[V+u]=X.a,o[j+u]=X.b)}if(f&A){let D=P+M;E?Pe(o[P+u],o[D+u]):He(o[P+u],o[D+u]),U=X.a,o[D+u]=X.b,o[P+u]=U}}if(w&A){let P=N,C=N+g*(f-R);for(;P<=C;P+=F){let D=P+O;E?Pe(o[P+u],o[D+u]):He(o[P+u],o[D+u]),U=X.a,o[D+u]=X.b,o[P+u]=U}}R=A,A>>=1}return N}function an(o,u,f,g,w,x,d,E,_){let A=0,R=0,N=d,k=Math.trunc(g.value+(w+7)/8);for(;g.value<k;)for(Se(A,R,f,g),A=de.c,R=de.lc;R>=14;){let z=A>>R-14&16383,O=u[z];if(O.len)R-=O.len,Le(O.lit,x,A,R,f,g,E,_,N),A=be.c,R=be.lc;else{if(!O.p)throw new Error("THREE.EXRLoader: hufDecode issues");let F;for(F=0;F<O.lit;F++){let U=xe(o[O.p[F]]);for(;R<U&&g.value<k;)Se(A,R,f,g),A=de.c,R=de.lc;if(R>=U&&sn(o[O.p[F]])==(A>>R-U&(1<<U)-1)){R-=U,Le(O.p[F],x,A,R,f,g,E,_,N),A=be.c,R=be.lc;break}}if(F==O.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let M=8-w&7;for(A>>=M,R-=M;R>0;){let z=u[A<<14-R&16383];if(z.len)R-=z.len,Le(z.lit,x,A,R,f,g,E,_,N),A=be.c,R=be.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function Mt(o,u,f,g,w,x){let d={value:0},E=f.value,_=he(u,f),A=he(u,f);f.value+=4;let R=he(u,f);if(f.value+=4,_<0||_>=65537||A<0||A>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let N=new Array(65537),k=new Array(16384);rr(k);let M=g-(f.value-E);if(rn(o,f,M,_,A,N),R>8*(g-(f.value-E)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");ir(N,_,A,k),an(N,k,o,f,R,A,x,w,d)}function Mo(o,u,f){for(let g=0;g<f;++g)u[g]=o[u[g]]}function cn(o){for(let u=1;u<o.length;u++){let f=o[u-1]+o[u]-128;o[u]=f}}function ln(o,u){let f=0,g=Math.floor((o.length+1)/2),w=0,x=o.length-1;for(;!(w>x||(u[w++]=o[f++],w>x));)u[w++]=o[g++]}function sr(o){let u=o.byteLength,f=new Array,g=0,w=new DataView(o);for(;u>0;){let x=w.getInt8(g++);if(x<0){let d=-x;u-=d+1;for(let E=0;E<d;E++)f.push(w.getUint8(g++))}else{let d=x;u-=2;let E=w.getUint8(g++);for(let _=0;_<d+1;_++)f.push(E)}}return f}function Fo(o,u,f,g,w,x){let d=new DataView(x.buffer),E=f[o.idx[0]].width,_=f[o.idx[0]].height,A=3,R=Math.floor(E/8),N=Math.ceil(E/8),k=Math.ceil(_/8),M=E-(N-1)*8,z=_-(k-1)*8,O={value:0},F=new Array(A),U=new Array(A),G=new Array(A),$=new Array(A),Z=new Array(A);for(let C=0;C<A;++C)Z[C]=u[o.idx[C]],F[C]=C<1?0:F[C-1]+N*k,U[C]=new Float32Array(64),G[C]=new Uint16Array(64),$[C]=new Uint16Array(N*64);for(let C=0;C<k;++C){let D=8;C==k-1&&(D=z);let V=8;for(let H=0;H<N;++H){H==N-1&&(V=M);for(let q=0;q<A;++q)G[q].fill(0),G[q][0]=w[F[q]++],ii(O,g,G[q]),si(G[q],U[q]),oi(U[q]);A==3&&Co(U);for(let q=0;q<A;++q)li(U[q],$[q],H*64)}let j=0;for(let H=0;H<A;++H){let q=f[o.idx[H]].type;for(let te=8*C;te<8*C+D;++te){j=Z[H][te];for(let pe=0;pe<R;++pe){let K=pe*64+(te&7)*8;d.setUint16(j+0*q,$[H][K+0],!0),d.setUint16(j+2*q,$[H][K+1],!0),d.setUint16(j+4*q,$[H][K+2],!0),d.setUint16(j+6*q,$[H][K+3],!0),d.setUint16(j+8*q,$[H][K+4],!0),d.setUint16(j+10*q,$[H][K+5],!0),d.setUint16(j+12*q,$[H][K+6],!0),d.setUint16(j+14*q,$[H][K+7],!0),j+=16*q}}if(R!=N)for(let te=8*C;te<8*C+D;++te){let pe=Z[H][te]+8*R*2*q,K=R*64+(te&7)*8;for(let Te=0;Te<V;++Te)d.setUint16(pe+Te*2*q,$[H][K+Te],!0)}}}let P=new Uint16Array(E);d=new DataView(x.buffer);for(let C=0;C<A;++C){f[o.idx[C]].decoded=!0;let D=f[o.idx[C]].type;if(f[C].type==2)for(let V=0;V<_;++V){let j=Z[C][V];for(let H=0;H<E;++H)P[H]=d.getUint16(j+H*2*D,!0);for(let H=0;H<E;++H)d.setFloat32(j+H*2*D,I.fromHalfFloat(P[H]),!0)}}}function zo(o,u,f,g,w,x){let d=new DataView(x.buffer),E=f[o],_=E.width,A=E.height,R=Math.ceil(_/8),N=Math.ceil(A/8),k=Math.floor(_/8),M=_-(R-1)*8,z=A-(N-1)*8,O={value:0},F=0,U=new Float32Array(64),G=new Uint16Array(64),$=new Uint16Array(R*64);for(let Z=0;Z<N;++Z){let P=8;Z==N-1&&(P=z);for(let C=0;C<R;++C)G.fill(0),G[0]=w[F++],ii(O,g,G),si(G,U),oi(U),li(U,$,C*64);for(let C=8*Z;C<8*Z+P;++C){let D=u[o][C];for(let V=0;V<k;++V){let j=V*64+(C&7)*8;for(let H=0;H<8;++H)d.setUint16(D+H*2*E.type,$[j+H],!0);D+=16*E.type}if(R!=k){let V=k*64+(C&7)*8;for(let j=0;j<M;++j)d.setUint16(D+j*2*E.type,$[V+j],!0)}}}E.decoded=!0}function ii(o,u,f){let g,w=1;for(;w<64;)g=u[o.value],g==65280?w=64:g>>8==255?w+=g&255:(f[w]=g,w++),o.value++}function si(o,u){u[0]=I.fromHalfFloat(o[0]),u[1]=I.fromHalfFloat(o[1]),u[2]=I.fromHalfFloat(o[5]),u[3]=I.fromHalfFloat(o[6]),u[4]=I.fromHalfFloat(o[14]),u[5]=I.fromHalfFloat(o[15]),u[6]=I.fromHalfFloat(o[27]),u[7]=I.fromHalfFloat(o[28]),u[8]=I.fromHalfFloat(o[2]),u[9]=I.fromHalfFloat(o[4]),u[10]=I.fromHalfFloat(o[7]),u[11]=I.fromHalfFloat(o[13]),u[12]=I.fromHalfFloat(o[16]),u[13]=I.fromHalfFloat(o[26]),u[14]=I.fromHalfFloat(o[29]),u[15]=I.fromHalfFloat(o[42]),u[16]=I.fromHalfFloat(o[3]),u[17]=I.fromHalfFloat(o[8]),u[18]=I.fromHalfFloat(o[12]),u[19]=I.fromHalfFloat(o[17]),u[20]=I.fromHalfFloat(o[25]),u[21]=I.fromHalfFloat(o[30]),u[22]=I.fromHalfFloat(o[41]),u[23]=I.fromHalfFloat(o[43]),u[24]=I.fromHalfFloat(o[9]),u[25]=I.fromHalfFloat(o[11]),u[26]=I.fromHalfFloat(o[18]),u[27]=I.fromHalfFloat(o[24]),u[28]=I.fromHalfFloat(o[31]),u[29]=I.fromHalfFloat(o[40]),u[30]=I.fromHalfFloat(o[44]),u[31]=I.fromHalfFloat(o[53]),u[32]=I.fromHalfFloat(o[10]),u[33]=I.fromHalfFloat(o[19]),u[34]=I.fromHalfFloat(o[23]),u[35]=I.fromHalfFloat(o[32]),u[36]=I.fromHalfFloat(o[39]),u[37]=I.fromHalfFloat(o[45]),u[38]=I.fromHalfFloat(o[52]),u[39]=I.fromHalfFloat(o[54]),u[40]=I.fromHalfFloat(o[20]),u[41]=I.fromHalfFloat(o[22]),u[42]=I.fromHalfFloat(o[33]),u[43]=I.fromHalfFloat(o[38]),u[44]=I.fromHalfFloat(o[46]),u[45]=I.fromHalfFloat(o[51]),u[46]=I.fromHalfFloat(o[55]),u[47]=I.fromHalfFloat(o[60]),u[48]=I.fromHalfFloat(o[21]),u[49]=I.fromHalfFloat(o[34]),u[50]=I.fromHalfFloat(o[37]),u[51]=I.fromHalfFloat(o[47]),u[52]=I.fromHalfFloat(o[50]),u[53]=I.fromHalfFloat(o[56]),u[54]=I.fromHalfFloat(o[59]),u[55]=I.fromHalfFloat(o[61]),u[56]=I.fromHalfFloat(o[35]),u[57]=I.fromHalfFloat(o[36]),u[58]=I.fromHalfFloat(o[48]),u[59]=I.fromHalfFloat(o[49]),u[60]=I.fromHalfFloat(o[57]),u[61]=I.fromHalfFloat(o[58]),u[62]=I.fromHalfFloat(o[62]),u[63]=I.fromHalfFloat(o[63])}function oi(o){let u=.5*Math.cos(.7853975),f=.5*Math.cos(3.14159/16),g=.5*Math.cos(3.14159/8),w=.5*Math.cos(3*3.14159/16),x=.5*Math.cos(5*3.14159/16),d=.5*Math.cos(3*3.14159/8),E=.5*Math.cos(7*3.14159/16),_=new Array(4),A=new Array(4),R=new Array(4),N=new Array(4);for(let k=0;k<8;++k){let M=k*8;_[0]=g*o[M+2],_[1]=d*o[M+2],_[2]=g*o[M+6],_[3]=d*o[M+6],A[0]=f*o[M+1]+w*o[M+3]+x*o[M+5]+E*o[M+7],A[1]=w*o[M+1]-E*o[M+3]-f*o[M+5]-x*o[M+7],A[2]=x*o[M+1]-f*o[M+3]+E*o[M+5]+w*o[M+7],A[3]=E*o[M+1]-x*o[M+3]+w*o[M+5]-f*o[M+7],R[0]=u*(o[M+0]+o[M+4]),R[3]=u*(o[M+0]-o[M+4]),R[1]=_[0]+_[3],R[2]=_[1]-_[2],N[0]=R[0]+R[1],N[1]=R[3]+R[2],N[2]=R[3]-R[2],N[3]=R[0]-R[1],o[M+0]=N[0]+A[0],o[M+1]=N[1]+A[1],o[M+2]=N[2]+A[2],o[M+3]=N[3]+A[3],o[M+4]=N[3]-A[3],o[M+5]=N[2]-A[2],o[M+6]=N[1]-A[1],o[M+7]=N[0]-A[0]}for(let k=0;k<8;++k)_[0]=g*o[16+k],_[1]=d*o[16+k],_[2]=g*o[48+k],_[3]=d*o[48+k],A[0]=f*o[8+k]+w*o[24+k]+x*o[40+k]+E*o[56+k],A[1]=w*o[8+k]-E*o[24+k]-f*o[40+k]-x*o[56+k],A[2]=x*o[8+k]-f*o[24+k]+E*o[40+k]+w*o[56+k],A[3]=E*o[8+k]-x*o[24+k]+w*o[40+k]-f*o[56+k],R[0]=u*(o[k]+o[32+k]),R[3]=u*(o[k]-o[32+k]),R[1]=_[0]+_[3],R[2]=_[1]-_[2],N[0]=R[0]+R[1],N[1]=R[3]+R[2],N[2]=R[3]-R[2],N[3]=R[0]-R[1],o[0+k]=N[0]+A[0],o[8+k]=N[1]+A[1],o[16+k]=N[2]+A[2],o[24+k]=N[3]+A[3],o[32+k]=N[3]-A[3],o[40+k]=N[2]-A[2],o[48+k]=N[1]-A[1],o[56+k]=N[0]-A[0]}function Co(o){for(let u=0;u<64;++u){let f=o[0][u],g=o[1][u],w=o[2][u];o[0][u]=f+1.5747*w,o[1][u]=f-.1873*g-.4682*w,o[2][u]=f+1.8556*g}}let or=new Float32Array(1),ai=new Uint32Array(or.buffer);function ci(o){or[0]=o;let u=ai[0],f=u>>>16&32768,g=u&2147483647;if(g>=1199570944)return f|(g>2139095040?32256:31744);if(g<947912704)return or[0]=Math.abs(o)+.5,f|ai[0]-1056964608;let w=g+4095+(g>>>13&1);return f|w-939524096>>>13}function li(o,u,f){if(re===null){re=new Uint16Array(65536);for(let g=1;g<65536;++g){if((g&31744)===31744)continue;let w=I.fromHalfFloat(g),x=Math.abs(w),d=x<=1?Math.pow(x,2.2):Math.pow(Ke,x-1);re[g]=ci(w<0?-d:d)}}for(let g=0;g<64;++g)u[f+g]=re[ci(o[g])]}function un(o){return new DataView(o.array.buffer,o.offset.value,o.size)}function Lo(o){let u=o.viewer.buffer.slice(o.offset.value,o.offset.value+o.size),f=new Uint8Array(sr(u)),g=new Uint8Array(f.length);return cn(f),ln(f,g),new DataView(g.buffer)}function ar(o){let u=o.array.slice(o.offset.value,o.offset.value+o.size),f=Tt(u),g=new Uint8Array(f.length);return cn(f),ln(f,g),new DataView(g.buffer)}function Po(o){let u=o.viewer,f={value:o.offset.value},g=new Uint16Array(o.columns*o.lines*(o.inputChannels.length*o.type)),w=new Uint8Array(8192),x=0,d=new Array(o.inputChannels.length);for(let z=0,O=o.inputChannels.length;z<O;z++)d[z]={},d[z].start=x,d[z].end=d[z].start,d[z].nx=o.columns,d[z].ny=o.lines,d[z].size=o.type,x+=d[z].nx*d[z].ny*d[z].size;let E=Ft(u,f),_=Ft(u,f);if(_>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(E<=_)for(let z=0;z<_-E+1;z++)w[z+E]=Ge(u,f);let A=new Uint16Array(65536),R=nn(w,A),N=he(u,f);Mt(o.array,u,f,N,g,x);for(let z=0;z<o.inputChannels.length;++z){let O=d[z];for(let F=0;F<d[z].size;++F)on(g,O.start+F,O.nx,O.size,O.ny,O.nx*O.size,R)}Mo(A,g,x);let k=0,M=new Uint8Array(g.buffer.byteLength);for(let z=0;z<o.lines;z++)for(let O=0;O<o.inputChannels.length;O++){let F=d[O],U=F.nx*F.size,G=new Uint8Array(g.buffer,F.end*2,U*2);M.set(G,k),k+=U*2,F.end+=U}return new DataView(M.buffer)}function Do(o){let u=o.array.slice(o.offset.value,o.offset.value+o.size),f=Tt(u),g=o.inputChannels.length*o.lines*o.columns*o.totalBytes,w=new ArrayBuffer(g),x=new DataView(w),d=0,E=0,_=new Array(4);for(let A=0;A<o.lines;A++)for(let R=0;R<o.inputChannels.length;R++){let N=0;switch(o.inputChannels[R].pixelType){case 1:_[0]=d,_[1]=_[0]+o.columns,d=_[1]+o.columns;for(let M=0;M<o.columns;++M){let z=f[_[0]++]<<8|f[_[1]++];N+=z,x.setUint16(E,N,!0),E+=2}break;case 2:_[0]=d,_[1]=_[0]+o.columns,_[2]=_[1]+o.columns,d=_[2]+o.columns;for(let M=0;M<o.columns;++M){let z=f[_[0]++]<<24|f[_[1]++]<<16|f[_[2]++]<<8;N+=z,x.setUint32(E,N,!0),E+=4}break}}return x}function Uo(o){let u=o.array,f=o.offset.value,g=o.columns,w=o.lines,x=o.inputChannels,d=o.totalBytes,E=oe.compression==="B44A_COMPRESSION",_=new Uint8Array(w*g*d),A=new Uint16Array(16),R=0;for(let N=0;N<x.length;N++){let k=x[N],M=k.pixelType*2,z=Math.ceil(g/k.xSampling),O=Math.ceil(w/k.ySampling),F=k.xSampling===1&&k.ySampling===1;if(k.pixelType!==1){for(let $=0;$<O;$++)if(F){let Z=$*g*d+R*g;for(let P=0;P<z*M;P++)_[Z+P]=u[f++]}else f+=z*M;R+=M;continue}let U=Math.ceil(z/4),G=Math.ceil(O/4);for(let $=0;$<G;$++)for(let Z=0;Z<U;Z++){if(E&&u[f+2]>=52){let P=u[f]<<8|u[f+1],C=P&32768?P&32767:~P&65535;A.fill(C),f+=3}else{let P=u[f]<<8|u[f+1],C=u[f+2]>>2,D=32<<C,V=P+((u[f+2]<<4|u[f+3]>>4)&63)*(1<<C)-D&65535,j=V+((u[f+3]<<2|u[f+4]>>6)&63)*(1<<C)-D&65535,H=j+(u[f+4]&63)*(1<<C)-D&65535,q=P+(u[f+5]>>2&63)*(1<<C)-D&65535,te=V+((u[f+5]<<4|u[f+6]>>4)&63)*(1<<C)-D&65535,pe=j+((u[f+6]<<2|u[f+7]>>6)&63)*(1<<C)-D&65535,K=H+(u[f+7]&63)*(1<<C)-D&65535,Te=q+(u[f+8]>>2&63)*(1<<C)-D&65535,at=te+((u[f+8]<<4|u[f+9]>>4)&63)*(1<<C)-D&65535,zt=pe+((u[f+9]<<2|u[f+10]>>6)&63)*(1<<C)-D&65535,Ne=K+(u[f+10]&63)*(1<<C)-D&65535,Qe=Te+(u[f+11]>>2&63)*(1<<C)-D&65535,dn=at+((u[f+11]<<4|u[f+12]>>4)&63)*(1<<C)-D&65535,gn=zt+((u[f+12]<<2|u[f+13]>>6)&63)*(1<<C)-D&65535,vn=Ne+(u[f+13]&63)*(1<<C)-D&65535,Ct=[P,q,Te,Qe,V,te,at,dn,j,pe,zt,gn,H,K,Ne,vn];for(let ct=0;ct<16;ct++)A[ct]=Ct[ct]&32768?Ct[ct]&32767:~Ct[ct]&65535;f+=14}if(k.pLinear){if(Ce===null){Ce=new Uint16Array(65536);for(let P=0;P<65536;P++)if((P&31744)===31744||P>32768)Ce[P]=0;else{let C=I.fromHalfFloat(P);Ce[P]=C<=0?0:I.toHalfFloat(8*Math.log(C))}}for(let P=0;P<16;P++)A[P]=Ce[A[P]]}for(let P=0;P<4;P++){let C=$*4+P;if(!(C>=O))for(let D=0;D<4;D++){let V=Z*4+D;if(V>=z)continue;let j=A[P*4+D];for(let H=0;H<k.ySampling;H++){let q=C*k.ySampling+H;if(!(q>=w))for(let te=0;te<k.xSampling;te++){let pe=V*k.xSampling+te;if(pe>=g)continue;let K=q*g*d+R*g+pe*2;_[K]=j&255,_[K+1]=j>>8&255}}}}}R+=2}return new DataView(_.buffer)}function ui(o){let u=o.viewer,f={value:o.offset.value},g=new Uint8Array(o.columns*o.lines*(o.inputChannels.length*o.type*2)),w={version:ne(u,f),unknownUncompressedSize:ne(u,f),unknownCompressedSize:ne(u,f),acCompressedSize:ne(u,f),dcCompressedSize:ne(u,f),rleCompressedSize:ne(u,f),rleUncompressedSize:ne(u,f),rleRawSize:ne(u,f),totalAcUncompressedCount:ne(u,f),totalDcUncompressedCount:ne(u,f),acCompression:ne(u,f)};if(w.version<2)throw new Error("THREE.EXRLoader: "+oe.compression+" version "+w.version+" is unsupported");let x=new Array,d=Ft(u,f)-2;for(;d>0;){let O=fn(u.buffer,f),F=Ge(u,f),U=F>>2&3,G=(F>>4)-1,$=new Int8Array([G])[0],Z=Ge(u,f);x.push({name:O,index:$,type:Z,compression:U}),d-=O.length+3}let E=oe.channels,_=new Array(o.inputChannels.length);for(let O=0;O<o.inputChannels.length;++O){let F=_[O]={},U=E[O];F.name=U.name,F.compression=0,F.decoded=!1,F.type=U.pixelType,F.pLinear=U.pLinear,F.width=o.columns,F.height=o.lines}let A={idx:new Array(3)};for(let O=0;O<o.inputChannels.length;++O){let F=_[O],U=F.name.lastIndexOf("."),G=U>=0?F.name.substring(U+1):F.name;for(let $=0;$<x.length;++$){let Z=x[$];G===Z.name&&F.type===Z.type&&(F.compression=Z.compression,Z.index>=0&&(A.idx[Z.index]=O),F.offset=O)}}let R,N,k;if(w.acCompressedSize>0)switch(w.acCompression){case 0:R=new Uint16Array(w.totalAcUncompressedCount),Mt(o.array,u,f,w.acCompressedSize,R,w.totalAcUncompressedCount);break;case 1:let O=o.array.slice(f.value,f.value+w.totalAcUncompressedCount),F=Tt(O);R=new Uint16Array(F.buffer),f.value+=w.totalAcUncompressedCount;break}if(w.dcCompressedSize>0){let O={array:o.array,offset:f,size:w.dcCompressedSize};N=new Uint16Array(ar(O).buffer),f.value+=w.dcCompressedSize}if(w.rleRawSize>0){let O=o.array.slice(f.value,f.value+w.rleCompressedSize),F=Tt(O);k=sr(F.buffer),f.value+=w.rleCompressedSize}let M=0,z=new Array(_.length);for(let O=0;O<z.length;++O)z[O]=new Array;for(let O=0;O<o.lines;++O)for(let F=0;F<_.length;++F)z[F].push(M),M+=_[F].width*o.type*2;A.idx[0]!==void 0&&_[A.idx[0]]&&Fo(A,z,_,R,N,g);for(let O=0;O<_.length;++O){let F=_[O];if(!F.decoded)switch(F.compression){case 2:let U=0,G=0;for(let $=0;$<o.lines;++$){let Z=z[O][U];for(let P=0;P<F.width;++P){for(let C=0;C<2*F.type;++C)g[Z++]=k[G+C*F.width*F.height];G++}U++}break;case 1:zo(O,z,_,R,N,g);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(g.buffer)}function fn(o,u){let f=new Uint8Array(o),g=0;for(;f[u.value+g]!=0;)g+=1;let w=new TextDecoder().decode(f.slice(u.value,u.value+g));return u.value=u.value+g+1,w}function Bo(o,u,f){let g=new TextDecoder().decode(new Uint8Array(o).slice(u.value,u.value+f));return u.value=u.value+f,g}function $o(o,u){let f=le(o,u),g=he(o,u);return[f,g]}function Ho(o,u){let f=he(o,u),g=he(o,u);return[f,g]}function le(o,u){let f=o.getInt32(u.value,!0);return u.value=u.value+4,f}function he(o,u){let f=o.getUint32(u.value,!0);return u.value=u.value+4,f}function fi(o,u){let f=o[u.value];return u.value=u.value+1,f}function Ge(o,u){let f=o.getUint8(u.value);return u.value=u.value+1,f}let ne=function(o,u){let f=Number(o.getBigInt64(u.value,!0));return u.value+=8,f};function se(o,u){let f=o.getFloat32(u.value,!0);return u.value+=4,f}function Go(o,u){return I.toHalfFloat(se(o,u))}function Ft(o,u){let f=o.getUint16(u.value,!0);return u.value+=2,f}function qo(o,u){return I.fromHalfFloat(Ft(o,u))}function Zo(o,u,f,g){let w=f.value,x=[];for(;f.value<w+g-1;){let d=fn(u,f),E=le(o,f),_=Ge(o,f);f.value+=3;let A=le(o,f),R=le(o,f);x.push({name:d,pixelType:E,pLinear:_,xSampling:A,ySampling:R})}return f.value+=1,x}function jo(o,u){let f=se(o,u),g=se(o,u),w=se(o,u),x=se(o,u),d=se(o,u),E=se(o,u),_=se(o,u),A=se(o,u);return{redX:f,redY:g,greenX:w,greenY:x,blueX:d,blueY:E,whiteX:_,whiteY:A}}function Wo(o,u){let f=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],g=Ge(o,u);return f[g]}function Yo(o,u){let f=le(o,u),g=le(o,u),w=le(o,u),x=le(o,u);return{xMin:f,yMin:g,xMax:w,yMax:x}}function Vo(o,u){let f=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],g=Ge(o,u);return f[g]}function Xo(o,u){let f=["ENVMAP_LATLONG","ENVMAP_CUBE"],g=Ge(o,u);return f[g]}function Ko(o,u){let f=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],g=["ROUND_DOWN","ROUND_UP"],w=he(o,u),x=he(o,u),d=Ge(o,u);return{xSize:w,ySize:x,levelMode:f[d&15],roundingMode:g[d>>4]}}function Jo(o,u){let f=se(o,u),g=se(o,u);return[f,g]}function Qo(o,u){let f=se(o,u),g=se(o,u),w=se(o,u);return[f,g,w]}function ea(o,u,f,g,w){if(g==="string"||g==="stringvector"||g==="iccProfile")return Bo(u,f,w);if(g==="chlist")return Zo(o,u,f,w);if(g==="chromaticities")return jo(o,f);if(g==="compression")return Wo(o,f);if(g==="box2i")return Yo(o,f);if(g==="envmap")return Xo(o,f);if(g==="tiledesc")return Ko(o,f);if(g==="lineOrder")return Vo(o,f);if(g==="float")return se(o,f);if(g==="v2f")return Jo(o,f);if(g==="v3f")return Qo(o,f);if(g==="int")return le(o,f);if(g==="rational")return $o(o,f);if(g==="timecode")return Ho(o,f);if(g==="preview"||g==="deepImageState"||g==="idmanifest")return f.value+=w,"skipped";f.value+=w}function ta(o,u){let f=Math.log2(o);return u=="ROUND_DOWN"?Math.floor(f):Math.ceil(f)}function na(o,u,f){let g=0;switch(o.levelMode){case"ONE_LEVEL":g=1;break;case"MIPMAP_LEVELS":g=ta(Math.max(u,f),o.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return g}function hi(o,u,f,g){let w=new Array(o);for(let x=0;x<o;x++){let d=1<<x,E=u/d|0;g=="ROUND_UP"&&E*d<u&&(E+=1);let _=Math.max(E,1);w[x]=(_+f-1)/f|0}return w}function ra(){let o=this,u=o.offset,f={value:0};for(let g=0;g<o.tileCount;g++){let w=le(o.viewer,u),x=le(o.viewer,u);u.value+=8,o.size=he(o.viewer,u);let d=w*o.blockWidth,E=x*o.blockHeight;o.columns=d+o.blockWidth>o.width?o.width-d:o.blockWidth,o.lines=E+o.blockHeight>o.height?o.height-E:o.blockHeight;let _=o.columns*o.totalBytes,R=o.size<o.lines*_?o.uncompress(o):un(o);u.value+=o.size;for(let N=0;N<o.lines;N++){let k=N*o.columns*o.totalBytes;for(let M=0;M<o.inputChannels.length;M++){let z=oe.channels[M].name,O=o.channelByteOffsets[z]*o.columns,F=o.decodeChannels[z];if(F===void 0)continue;f.value=k+O;let U=(o.height-(1+E+N))*o.outLineWidth;for(let G=0;G<o.columns;G++){let $=U+(G+d)*o.outputChannels+F;o.byteArray[$]=o.getter(R,f)}}}}}function ia(){let o=this,u=o.offset,f={value:0};for(let g=0;g<o.height/o.blockHeight;g++){let w=le(o.viewer,u)-oe.dataWindow.yMin;o.size=he(o.viewer,u),o.lines=w+o.blockHeight>o.height?o.height-w:o.blockHeight;let x=o.columns*o.totalBytes,E=o.size<o.lines*x?o.uncompress(o):un(o);u.value+=o.size;for(let _=0;_<o.lines;_++){let A=w+_,R=_*x,N=(o.height-1-A)*o.outLineWidth;for(let k=0;k<o.inputChannels.length;k++){let M=oe.channels[k].name,z=o.channelByteOffsets[M]*o.columns,O=o.decodeChannels[M];if(O!==void 0){f.value=R+z;for(let F=0;F<o.columns;F++){let U=N+F*o.outputChannels+O;o.byteArray[U]=o.getter(E,f)}}}}}}function sa(){let o=this,u=o.chunkOffsets,f={value:0};for(let g=0;g<u.length;g++){let w={value:u[g]};w.value+=4;let x=le(o.viewer,w)-oe.dataWindow.yMin;o.size=he(o.viewer,w),o.lines=x+o.blockHeight>o.height?o.height-x:o.blockHeight;let d=o.columns*o.totalBytes,E=o.size<o.lines*d,_=o.offset;o.offset=w;let A=E?o.uncompress(o):un(o);o.offset=_;for(let R=0;R<o.lines;R++){let N=x+R,k=R*d,M=(o.height-1-N)*o.outLineWidth;for(let z=0;z<o.inputChannels.length;z++){let O=oe.channels[z].name,F=o.channelByteOffsets[O]*o.columns,U=o.decodeChannels[O];if(U!==void 0){f.value=k+F;for(let G=0;G<o.columns;G++){let $=M+G*o.outputChannels+U;o.byteArray[$]=o.getter(A,f)}}}}}}function pi(o,u,f,g){if(f===0)return null;let w=o.slice(u,u+f);switch(g){case"NO_COMPRESSION":return new DataView(w.buffer,w.byteOffset,w.byteLength);case"RLE_COMPRESSION":{let x=new Uint8Array(sr(w.buffer.slice(w.byteOffset,w.byteOffset+w.byteLength))),d=new Uint8Array(x.length);return cn(x),ln(x,d),new DataView(d.buffer)}case"ZIPS_COMPRESSION":{let x=Tt(w),d=new Uint8Array(x.length);return cn(x),ln(x,d),new DataView(d.buffer)}default:throw new Error("THREE.EXRLoader: "+g+" is unsupported for deep data")}}function oa(){let o=this,u=o.chunkOffsets,f=o.width,g=o.height,w=o.deepChannels,x=oe.compression,d=o.multiPart,E=o.decodeChannels,_=o.outputChannels,A=o.byteArray instanceof Uint16Array,R=-1;for(let N=0;N<w.length;N++)if(w[N].name==="A"){R=N;break}for(let N=0;N<u.length;N++){let k={value:u[N]};d&&(k.value+=4);let M=le(o.viewer,k)-oe.dataWindow.yMin,z=ne(o.viewer,k),O=ne(o.viewer,k);ne(o.viewer,k);let F=pi(o.array,k.value,z,x);if(k.value+=z,F===null)continue;let U=new Uint32Array(f);for(let D=0;D<f;D++)U[D]=F.getUint32(D*4,!0);let G=U[f-1];if(G===0){k.value+=O;continue}let $=pi(o.array,k.value,O,x),Z=[],P=0;for(let D=0;D<w.length;D++)Z.push(P),P+=G*w[D].bytesPerSample;let C=(g-1-M)*o.outLineWidth;for(let D=0;D<f;D++){let V=D===0?0:U[D-1],H=U[D]-V;if(H===0)continue;let q=new Float32Array(_),te=0;for(let K=0;K<H;K++){let Te=V+K,at=1-te;if(at<=0)break;let zt=1;if(R>=0){let Ne=w[R].bytesPerSample,Qe=Z[R]+Te*Ne;zt=Ne===2?I.fromHalfFloat($.getUint16(Qe,!0)):$.getFloat32(Qe,!0)}for(let Ne=0;Ne<w.length;Ne++){let Qe=w[Ne],dn=E[Qe.name];if(dn===void 0)continue;let gn=Qe.bytesPerSample,vn=Z[Ne]+Te*gn,Ct=gn===2?I.fromHalfFloat($.getUint16(vn,!0)):$.getFloat32(vn,!0);q[dn]+=Ct*at}te+=zt*at}E.A!==void 0&&(q[E.A]=te);let pe=C+D*_;for(let K=0;K<_;K++)o.byteArray[pe+K]=A?I.toHalfFloat(q[K]):q[K]}}}function mi(o,u,f){let g={},w=!1;for(;;){let x=fn(u,f);if(x==="")break;w=!0;let d=fn(u,f),E=he(o,f),_=ea(o,u,f,d,E);_===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${d}'.`):g[x]=_}return w?g:null}function aa(o,u,f){if(o.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let g=o.getUint8(4),w=o.getUint8(5),x={singleTile:!!(w&2),longName:!!(w&4),deepFormat:!!(w&8),multiPart:!!(w&16)};f.value=8;let d=[];if(x.multiPart){for(;;){let E=mi(o,u,f);if(E===null)break;E.version=g,E.spec=x,d.push(E)}if(d.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let E=mi(o,u,f);E.version=g,E.spec=x,d.push(E)}return d}function ca(o,u,f,g,w,x){let d={size:0,viewer:u,array:f,offset:g,width:o.dataWindow.xMax-o.dataWindow.xMin+1,height:o.dataWindow.yMax-o.dataWindow.yMin+1,inputChannels:o.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:Xe};switch(o.compression){case"NO_COMPRESSION":d.blockHeight=1,d.uncompress=un;break;case"RLE_COMPRESSION":d.blockHeight=1,d.uncompress=Lo;break;case"ZIPS_COMPRESSION":d.blockHeight=1,d.uncompress=ar;break;case"ZIP_COMPRESSION":d.blockHeight=16,d.uncompress=ar;break;case"PIZ_COMPRESSION":d.blockHeight=32,d.uncompress=Po;break;case"PXR24_COMPRESSION":d.blockHeight=16,d.uncompress=Do;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":d.blockHeight=32,d.uncompress=Uo;break;case"DWAA_COMPRESSION":d.blockHeight=32,d.uncompress=ui;break;case"DWAB_COMPRESSION":d.blockHeight=256,d.uncompress=ui;break;default:throw new Error("THREE.EXRLoader: "+o.compression+" is unsupported")}let E={};for(let k of o.channels)switch(k.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":E[k.name]=!0,d.type=k.pixelType}let _=!1,A=!1;if(E.Y&&E.RY&&E.BY)d.outputChannels=4,d.yCbCr=!0;else if(E.R&&E.G&&E.B)d.outputChannels=4;else if(E.Y)d.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(d.outputChannels){case 4:x==Ve?(_=!E.A,d.format=Ve,d.colorSpace=Xe,d.outputChannels=4,d.decodeChannels={R:0,G:1,B:2,A:3}):x==kt?(d.format=kt,d.colorSpace=Xe,d.outputChannels=2,d.decodeChannels={R:0,G:1}):x==Kt?(d.format=Kt,d.colorSpace=Xe,d.outputChannels=1,d.decodeChannels={R:0}):A=!0;break;case 1:x==Ve?(_=!0,d.format=Ve,d.colorSpace=Xe,d.outputChannels=4,d.shouldExpand=!0,d.decodeChannels={Y:0}):x==kt?(d.format=kt,d.colorSpace=Xe,d.outputChannels=2,d.shouldExpand=!0,d.decodeChannels={Y:0}):x==Kt?(d.format=Kt,d.colorSpace=Xe,d.outputChannels=1,d.decodeChannels={Y:0}):A=!0;break;default:A=!0}if(A)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(d.yCbCr&&(d.format=Ve,d.outputChannels=4,d.decodeChannels={Y:0,RY:1,BY:2},_=!0),d.type==1)switch(w){case Et:d.getter=qo;break;case Rt:d.getter=Ft;break}else if(d.type==2)switch(w){case Et:d.getter=se;break;case Rt:d.getter=Go}else throw new Error("THREE.EXRLoader: unsupported pixelType "+d.type+" for "+o.compression+".");d.columns=d.width;let R=d.width*d.height*d.outputChannels;switch(w){case Et:d.byteArray=new Float32Array(R),_&&d.byteArray.fill(1,0,R);break;case Rt:d.byteArray=new Uint16Array(R),_&&d.byteArray.fill(15360,0,R);break;default:console.error("THREE.EXRLoader: unsupported type: ",w);break}let N=0;for(let k of o.channels)d.decodeChannels[k.name]!==void 0&&(d.channelByteOffsets[k.name]=N),N+=k.pixelType*2;if(d.totalBytes=N,d.outLineWidth=d.width*d.outputChannels,o.spec.deepFormat){d.deepChannels=[];let k=0;for(let M of o.channels){let z=M.pixelType===0?4:M.pixelType*2;d.deepChannels.push({name:M.name,pixelType:M.pixelType,bytesPerSample:z}),k+=z}d.deepBytesPerSample=k,d.chunkOffsets=o._chunkOffsets,d.multiPart=o.spec.multiPart,d.decode=oa.bind(d)}else if(o.spec.singleTile){d.blockHeight=o.tiles.ySize,d.blockWidth=o.tiles.xSize;let k=na(o.tiles,d.width,d.height),M=hi(k,d.width,o.tiles.xSize,o.tiles.roundingMode),z=hi(k,d.height,o.tiles.ySize,o.tiles.roundingMode);d.tileCount=M[0]*z[0];for(let O=0;O<k;O++)for(let F=0;F<z[O];F++)for(let U=0;U<M[O];U++)ne(u,g);d.decode=ra.bind(d)}else if(o.spec.multiPart)d.blockWidth=d.width,d.chunkOffsets=o._chunkOffsets,d.decode=sa.bind(d);else{d.blockWidth=d.width;let k=Math.ceil(d.height/d.blockHeight);for(let M=0;M<k;M++)ne(u,g);d.decode=ia.bind(d)}return d}let hn={value:0},pn=new DataView(e),la=new Uint8Array(e),mn=aa(pn,e,hn),di=Math.max(0,Math.min(this.part,mn.length-1)),oe=mn[di];if(oe.spec.multiPart||oe.spec.deepFormat)for(let o=0;o<mn.length;o++){let u=mn[o].chunkCount;if(o===di){oe._chunkOffsets=[];for(let f=0;f<u;f++)oe._chunkOffsets.push(ne(pn,hn))}else for(let f=0;f<u;f++)ne(pn,hn)}let ge=ca(oe,pn,la,hn,this.type,this.outputFormat);if(ge.decode(),ge.shouldExpand){let o=ge.byteArray;if(this.outputFormat==Ve)for(let u=0;u<o.length;u+=4)o[u+2]=o[u+1]=o[u];else if(this.outputFormat==kt)for(let u=0;u<o.length;u+=2)o[u+1]=o[u]}if(ge.yCbCr){let o=ge.byteArray,u=ge.width*ge.height;if(this.type===Rt)for(let f=0;f<u;f++){let g=f*4,w=I.fromHalfFloat(o[g]),x=I.fromHalfFloat(o[g+1]),d=I.fromHalfFloat(o[g+2]),E=(1+x)*w,_=(1+d)*w,A=(w-E*.2126-_*.0722)/.7152;o[g]=I.toHalfFloat(Math.max(0,E)),o[g+1]=I.toHalfFloat(Math.max(0,A)),o[g+2]=I.toHalfFloat(Math.max(0,_))}else for(let f=0;f<u;f++){let g=f*4,w=o[g],x=o[g+1],d=o[g+2],E=(1+x)*w,_=(1+d)*w;o[g]=Math.max(0,E),o[g+1]=Math.max(0,(w-E*.2126-_*.0722)/.7152),o[g+2]=Math.max(0,_)}}return{header:oe,width:ge.width,height:ge.height,data:ge.byteArray,format:ge.format,colorSpace:ge.colorSpace,type:this.type,minFilter:Wr,magFilter:Wr,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var ho=32768,tu=2**27,po=2**28,mo=1024,nu=12,Kr=2**29,go=1e18;function Gn(n,e,t){let r=Math.max(n,e)>ho||n*e>tu;if(Math.min(n,e)<1||r)throw new B(`has ${n} x ${e} pixels; from 1 to ${ho} a side, 2^27 in all`);let i=n*e*nu;if(i>po&&i>mo*t)throw new B(`has ${n} x ${e} pixels in ${t} bytes; an image above ${po} bytes of radiance is at most ${mo} times its file`)}var ru=512,iu=2048,su=4096,Zn=["NO","RLE","ZIPS","ZIP","PIZ","PXR24","B44","B44A","DWAA","DWAB"],ou=0,au=2,cu=2,lu=4096,vo=["RY","BY"];function yo(n){let{parts:e,flags:t}=du(n),r=fu(e),i=e[r];hu(i,e.length,t);for(let ee of[i.dataWindow,i.displayWindow])Gn(...qn(ee),n.length);let s=e.reduce((ee,J)=>ee+Math.max(0,uu(J)),0);if(s>Kr)throw new B(`has ${s} values in all its channels; at most ${Kr}`);let a=i.dataWindow,c=i.displayWindow,l=Math.max(a[0],c[0]),h=Math.min(a[2],c[2]),p=Math.max(a[1],c[1]),m=Math.min(a[3],c[3]);if(l>h||p>m)throw new B("its data window lies outside its display window");pu(i);let b=new Hn().setDataType(Et).setPart(r).parse(mu(n,i).buffer),[S,T]=qn(c),[L]=qn(a),Y=new Float32Array(3*S*T);for(let ee=p;ee<=m;ee++){let J=a[3]-ee;for(let ce=l;ce<=h;ce++){let rt=4*(J*L+ce-a[0]),it=3*((ee-c[1])*S+ce-c[0]);for(let $e=0;$e<3;$e++)Y[it+$e]=b.data[rt+$e]}}return{rgb:Y,width:S,height:T}}function qn([n,e,t,r]){return[t-n+1,r-e+1]}function uu({dataWindow:n,channels:e}){let[t,r]=qn(n);return Math.max(0,t)*Math.max(0,r)*e.length}function Qr({channels:n}){let e=new Set(n.map(({name:t})=>t));return e.has("R")&&e.has("G")&&e.has("B")?["R","G","B"]:e.has("Y")&&!vo.some(t=>e.has(t))?["Y"]:[]}function fu(n){let e=n.findIndex(i=>Qr(i).length>0);if(e>=0)return e;let t=[...new Set(n.flatMap(({channels:i})=>i.map(({name:s})=>s)))].sort();if(["Y",...vo].every(i=>t.includes(i)))throw new B("has luminance and chroma (Y, RY, BY): save it with R, G and B");let r=t.length>12?` and ${t.length-12} more`:"";throw new B(`has no channels R, G and B, nor Y; it has ${t.slice(0,12).join(", ")||"none"}${r}`)}function hu(n,e,t){let r=n.type?n.type.startsWith("deep"):(t&iu)!==0,i=n.type?n.type==="tiledimage":(t&ru)!==0,s=a=>{throw new B(a)};r&&s("is a deep image, with any number of samples a pixel: flatten it"),n.envmap&&s("is a cube map: convert it to latitude and longitude"),n.channels.some(({x:a,y:c})=>a!==1||c!==1)&&s("has channels of fewer texels than others: save them all at full size"),Zn[n.compression]===void 0&&s(`has compression ${n.compression}, expected one of ${Zn.join(", ")}`),i&&e>1&&s("has tiles in one of several parts: save it with scan lines"),i&&n.levels===cu&&s("has tiles of several sizes by row and column: save it with one size")}function pu(n){let e=Qr(n),t=new Set;for(let{name:r,type:i}of n.channels)e.includes(r)&&t.add(["uint32","float16","float32"][i]);if(t.size>1||t.has("uint32"))throw new B(`has colours of type ${[...t].sort().join(", ")}, expected float16 or float32`)}function mu(n,e){let t=n.slice(),r=Qr(e),i=e.channels.find(({name:a})=>a===r[0]).type,s=["DWAA","DWAB"].includes(Zn[e.compression]);for(let a of e.channels)if(a.type===ou&&Zn[e.compression]!=="PXR24"&&(t[a.typeAt]=au),["A","Y","RY","BY"].includes(a.name)&&!r.includes(a.name)&&!(s&&a.type===i))for(let l=0;l<a.name.length;l++)t[a.at+l]|=32;return t}function du(n){let e=new DataView(n.buffer,n.byteOffset,n.length),t=e.getUint32(4,!0),r={bytes:n,view:e,at:8},i=[];do{let s=gu(r);if(s===null)break;i.push(s)}while(t&su);if(!i.length)throw new B("broken EXR image: it has no header");return{parts:i,flags:t}}function gu(n){let e={channels:null,compression:null,dataWindow:null,displayWindow:null,type:"",envmap:0,levels:0},{view:t}=n;for(let i=0;;i++){let s=Jr(n);if(s===""){if(i===0)return null;break}let a=Jr(n),c=t.getInt32(n.at,!0),l=n.at+4;if(c<0||l+c>n.bytes.length||i>lu)throw new B("broken EXR image: an attribute goes past the file's end");s==="channels"&&(e.channels=vu({...n,at:l})),s==="compression"&&(e.compression=t.getUint8(l)),(s==="dataWindow"||s==="displayWindow")&&(e[s]=[0,4,8,12].map(h=>t.getInt32(l+h,!0))),s==="type"&&(e.type=String.fromCharCode(...n.bytes.subarray(l,l+Math.min(c,64)))),s==="envmap"&&a==="envmap"&&(e.envmap=t.getUint8(l)),s==="tiles"&&(e.levels=t.getUint8(l+8)&15),n.at=l+c}let r=["channels","compression","dataWindow","displayWindow"].find(i=>e[i]===null);if(r!==void 0)throw new B(`broken EXR image: it has no ${r}`);return e}function vu(n){let e=[];for(;;){let t=n.at,r=Jr(n);if(r==="")return e;let i=n.at,{view:s}=n;e.push({name:r,at:t,typeAt:i,type:s.getInt32(i,!0),x:s.getInt32(i+8,!0),y:s.getInt32(i+12,!0)}),n.at+=16}}function Jr(n){let e=n.bytes.indexOf(0,n.at);if(e<0||e-n.at>255)throw new B("broken EXR image: its header does not end");let t=new TextDecoder("utf-8",{fatal:!0}).decode(n.bytes.subarray(n.at,e));return n.at=e+1,t}var yu=65536,wo=[8,32767],wu=/^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/,_u=/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/,ei=/^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g,we=n=>new B(`broken HDR image${n}`);function _o(n){let e=xu(n),{count:t,length:r,columns:i,back:s,exposure:a}=e,c=bu(n,e),l=1/a,[h,p]=i?[t,r]:[r,t],m=new Float32Array(3*h*p);for(let v=0;v<t;v++){let b=s[0]?t-1-v:v;for(let S=0;S<r;S++){let T=s[1]?r-1-S:S,L=4*(v*r+S),Y=3*(i?T*h+b:b*h+T),ee=c[L+3],J=ee>0?l*2**(ee-136):0;for(let ce=0;ce<3;ce++)m[Y+ce]=c[L+ce]*J}}return{rgb:m,width:h,height:p}}function xu(n){let e=[],t=0,r=-1;for(;r<0||e.length<r+2;){let m=n.subarray(0,yu).indexOf(10,t);if(m<0)throw we(": it has no header");e.push(Array.from(n.subarray(t,m),v=>String.fromCharCode(v)).join("")),t=m+1,r<0&&e.at(-1).replace(/\r+$/,"")===""&&(r=e.length-1)}let i=1;for(let m of e.slice(1,r)){let v=m.indexOf("="),[b,S]=v<0?[m,""]:[m.slice(0,v),m.slice(v+1)],T=b.replace(ei,""),L=S.replace(ei,"");if(T==="FORMAT"&&L!=="32-bit_rle_rgbe")throw we(`: format '${L}', expected 32-bit_rle_rgbe`);T==="EXPOSURE"&&(i*=_u.test(L)?Number(L)||1:0)}if(!(i>0&&i<1/0))throw we(": EXPOSURE is not a positive number");let s=e[r+1].replace(ei,""),a=wu.exec(s);if(a===null||a[2]===a[5])throw we(`: size '${s.slice(0,40)}', expected such as '-Y height +X width'`);let c=Number(a[3]),l=Number(a[6]),h=a[2]==="X",p=[a[1]+a[2],a[4]+a[5]].map(m=>m==="+Y"||m==="-X");return Gn(...h?[c,l]:[l,c],n.length),{offset:t,count:c,length:l,columns:h,back:p,exposure:i}}function bu(n,{offset:e,count:t,length:r}){let i=new Uint8Array(4*t*r),s=e;try{for(let a=0;a<t;a++)s=Au(n,s,i.subarray(4*a*r),r,a)}catch(a){if(n.length-e===i.length)return n.subarray(e);throw a}return i}function Au(n,e,t,r,i){if(r>=wo[0]&&r<=wo[1]&&e+4<=n.length&&n[e]===2&&n[e+1]===2&&n[e+2]<128){if(n[e+2]*256+n[e+3]!==r)throw we(`, line ${i}: a run goes past the line's end`);return Eu(n,e+4,t,r,i)}return Ru(n,e,t,r,i)}function Eu(n,e,t,r,i){for(let s=0;s<4;s++)for(let a=0;a<r;){if(e+2>n.length)throw we(`, line ${i}: the file ends there`);let c=n[e]>128,l=c?n[e]-128:n[e];if(l===0)throw we(`, line ${i}: a run of no pixels`);if(a+l>r)throw we(`, line ${i}: a run goes past the line's end`);if(e+1+(c?1:l)>n.length)throw we(`, line ${i}: the file ends there`);for(let h=0;h<l;h++)t[4*(a+h)+s]=n[e+1+(c?0:h)];a+=l,e+=c?2:1+l}return e}function Ru(n,e,t,r,i){let s=0,a=0;for(;s<r;){if(e+4>n.length)throw we(`, line ${i}: the file ends there`);if(n[e]===1&&n[e+1]===1&&n[e+2]===1){if(s===0)throw we(`, line ${i}: a run repeats a pixel, but there is none before it`);let c=a>16?1/0:n[e+3]*2**a;if(s+c>r)throw we(`, line ${i}: a run goes past the line's end`);for(let l=0;l<c;l++)t.copyWithin(4*(s+l),4*(s-1),4*s);s+=c,a+=8}else t.set(n.subarray(e,e+4),4*s),s+=1,a=0;e+=4}return e}var ku=[118,47,49,1],Su=[35,63];function ti(n,e){let t=new Uint8Array(n),r=s=>s.every((a,c)=>t[c]===a),i=r(ku)?yo:r(Su)?_o:null;if(i===null)throw new B(`${e}: is neither an EXR nor a Radiance HDR image`);try{return Tu(i(t))}catch(s){let a=s instanceof B?s.message:`cannot read the image: ${s.message??s}`;throw new B(`${e}: ${a}`)}}function Tu(n){let{rgb:e}=n,t=0;for(let r=0;r<e.length;r+=3){let i=!0;for(let s=r;s<r+3;s++)i&&=Number.isFinite(e[s])&&e[s]<=go,e[s]>0||(e[s]=0);i||t++}if(t)throw new B(`has ${t} texels that are not finite numbers of at most 1e+18`);return n}var Ot=.4*Math.PI/180,Nt=5*Math.PI/180;function xo(n,e){let t=new Map,r=null;n.addEventListener("pointerdown",s=>{t.set(s.pointerId,{x:s.clientX,y:s.clientY}),Nu(n,s.pointerId),n.classList.add("dragging"),t.size===2?r="two":t.size===1&&(r=s.button===2?"pan":s.button!==0?null:s.altKey||s.shiftKey?"light":"orbit")}),n.addEventListener("pointermove",s=>{let a=t.get(s.pointerId);if(!a)return;let c={x:s.clientX,y:s.clientY},l=c.x-a.x,h=c.y-a.y;r==="two"&&Ou(t,s.pointerId,a,c,e),t.set(s.pointerId,c),!(!l&&!h)&&(r==="orbit"&&e.orbit(-l*Ot,h*Ot,!0),r==="light"&&e.light(l*Ot,-h*Ot,!0),r==="pan"&&e.pan(-l/n.clientHeight,h/n.clientHeight,!0))});for(let s of["pointerup","pointercancel"])n.addEventListener(s,a=>{t.delete(a.pointerId)&&(t.size||(r=null,n.classList.remove("dragging"),e.settle()))});n.addEventListener("contextmenu",s=>s.preventDefault()),n.addEventListener("dblclick",()=>e.reset());let i=0;n.addEventListener("wheel",s=>{s.preventDefault();let a=s.deltaMode===0?s.deltaY:s.deltaY*32;e.zoom(Math.exp(Math.min(300,Math.max(-300,a))*.0012),!0),clearTimeout(i),i=setTimeout(()=>e.settle(),200)},{passive:!1}),n.addEventListener("keydown",s=>Iu(s,e))}function Nu(n,e){try{n.setPointerCapture(e)}catch{}}function Ou(n,e,t,r,i){let s=[...n].find(([c])=>c!==e)?.[1];if(!s)return;let a=c=>Math.hypot(c.x-s.x,c.y-s.y)||1;i.zoom(a(t)/a(r),!0),i.light(.5*(r.x-t.x)*Ot,-.5*(r.y-t.y)*Ot,!0)}function Iu(n,e){if(n.ctrlKey||n.metaKey)return;let t=n.altKey||n.shiftKey?e.light:e.orbit,r={ArrowLeft:()=>t(-Nt,0),ArrowRight:()=>t(Nt,0),ArrowUp:()=>t(0,Nt),ArrowDown:()=>t(0,-Nt),"+":()=>e.zoom(1/1.1),"=":()=>e.zoom(1/1.1),"-":()=>e.zoom(1.1),"[":()=>e.light(-Nt,0),"]":()=>e.light(Nt,0),Home:()=>e.reset()};Object.hasOwn(r,n.key)&&(n.preventDefault(),r[n.key]())}var Mu={studio:["Studio",to],white:["White from all sides",()=>Bn([1,1,1])]},Fu=[1.06,1,.9],jn=Math.PI/180,Wn=class{constructor(){this.images=new Map(Object.entries(Mu).map(([e,[t,r]])=>[e,{label:t,make:r}])),this.choice="studio",this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:null,imageTurn:0})}add(e,t){let r=`image-${this.images.size}`;return this.images.set(r,{label:e,make:()=>t}),r}tables(){let e=this.images.get(this.choice);return e.tables??=eo(e.make()),e.tables}lights(){let e=[],t=[0,0,0];for(let{direction:r,irradiance:i}of this.suns??[this._sun()]){if(!i.some(a=>a>0))continue;let s=zu(r,this.rotation*jn);e.push({kind:"sun",direction:s,colour:i}),i.forEach((a,c)=>{t[c]+=a*Math.max(0,s[1])})}if(this.strength>0){let r=[this.strength,this.strength,this.strength],i=(this.rotation+this.imageTurn)*jn;e.push({kind:"environment",colour:r,angle:i},{kind:"aroundPoint",colour:r,angle:i}),this.tables().up.forEach((s,a)=>{t[a]+=s*this.strength})}return{lights:e,irradiance:t}}_sun(){let e=this.sunHeight*jn,t=this.sunAzimuth*jn;return{direction:[Math.cos(e)*Math.sin(t),Math.sin(e),Math.cos(e)*Math.cos(t)],irradiance:Fu.map(r=>r*this.sun)}}};function zu([n,e,t],r){let i=Math.cos(r),s=Math.sin(r),a=Math.hypot(n,e,t);return[(i*n+s*t)/a,e/a,(i*t-s*n)/a]}var bo=89*Math.PI/180,Cu=.95,ze=(n,e,t=1)=>n.map((r,i)=>r+t*e[i]),Yn=(n,e)=>n.map(t=>t*e),ni=(n,e)=>n.reduce((t,r,i)=>t+r*e[i],0),Ao=n=>Yn(n,1/Math.hypot(...n)),Eo=([n,e,t],[r,i,s])=>[e*s-t*i,t*r-n*s,n*i-e*r],Vn=class{constructor(){Object.assign(this,{target:[0,0,0],azimuth:.6,elevation:.35,distance:1,fov:30})}frame({min:e,max:t},r){this.target=Yn(ze(e,t),.5),this.size=Math.hypot(...ze(t,e,-1))/2||1,this.distance=this.size;let{forward:i,side:s,above:a}=this._axes(),c=Cu*Math.tan(this.fov*Math.PI/360),h=Array.from({length:8},(p,m)=>ze([0,1,2].map(v=>(m>>v&1?t:e)[v]),this.target,-1)).map(p=>Math.max(Math.abs(ni(p,a)),Math.abs(ni(p,s))/r)/c-ni(p,i));this.distance=Math.max(...h)||this.size}lookFrom(e,t,r){let i=ze(e,t,-1);this.target=t,this.distance=Math.hypot(...i),this.azimuth=Math.atan2(i[0],i[2]),this.elevation=Math.asin(i[1]/this.distance),r&&(this.fov=r)}get position(){let e=Math.cos(this.elevation),t=[e*Math.sin(this.azimuth),Math.sin(this.elevation),e*Math.cos(this.azimuth)];return ze(this.target,t,this.distance)}turn(e,t){this.azimuth+=e,this.elevation=Math.min(bo,Math.max(-bo,this.elevation+t))}zoom(e){this.distance=Math.min(1e4*this.size,Math.max(.001*this.size,this.distance*e))}pan(e,t){let{side:r,above:i}=this._axes(),s=2*this.distance*Math.tan(this.fov*Math.PI/360);this.target=ze(ze(this.target,r,e*s),i,t*s)}camera(e,t){let{forward:r,side:i,above:s}=this._axes(),a=Math.tan(this.fov*Math.PI/360),c=a*e/t;return{position:this.position,corner:ze(ze(r,i,-c),s,a),stepX:Yn(i,2*c/e),stepY:Yn(s,-2*a/t)}}_axes(){let e=Ao(ze(this.target,this.position,-1)),t=Ao(Eo(e,[0,1,0]));return{forward:e,side:t,above:Eo(t,e)}}};var en=()=>null,Xn=(...n)=>e=>n.includes(e)?null:`expected ${n.join(" or ")}`,Ro=(n,e,t)=>r=>{let i=Number(r);return r.trim()!==""&&i>=n&&i<=e&&(!t||Number.isInteger(i))?null:`expected a ${t?"whole ":""}number from ${n} to ${e}`},Kn={asset:en,tier:en,env:en,scene:en,api:en,ui:Xn("0","1"),bench:Xn("0","1"),jitter:Xn("0","1"),view:Xn("srgb","filmic"),rounds:Ro(1,1e6,!0),dpr:Ro(.1,8,!1)};function ko(n,e){let t=new Map,r=[];for(let i of[n,e])for(let[s,a]of new URLSearchParams(i)){let c=Object.hasOwn(Kn,s)?Kn[s](a):Lu(s);c?r.push(Object.hasOwn(Kn,s)?`?${s}=: ${c}, found ${a}`:c):t.set(s,a)}return{parameters:t,problems:r}}function Lu(n){let e=Object.keys(Kn).find(t=>Pu(n.toLowerCase(),t)<=(t.length>3?2:1));return e?`?${n}= is no parameter of this page: did you mean ${e}=?`:null}function Pu(n,e){let t=[Array.from({length:e.length+1},(r,i)=>i)];for(let r=1;r<=n.length;r++){t.push([r]);for(let i=1;i<=e.length;i++){let s=r>1&&i>1&&n[r-1]===e[i-2]&&n[r-2]===e[i-1]?t[r-2][i-2]+1:1/0,a=t[r-1][i-1]+ +(n[r-1]!==e[i-1]);t[r].push(Math.min(t[r-1][i]+1,t[r][i-1]+1,a,s))}}return t[n.length][e.length]}function tn(n){return n.replaceAll("#","%23").replace(/%(?![0-9a-f]{2})/gi,"%25")}var So=100,Du=.7,Jn=class{constructor(e){this.app=e,ue("tier","change",({value:r})=>e.switchTier(r));let t=(r,i)=>{ue(r,"input",({valueAsNumber:s})=>this._setLight(i,s,!0)),ue(r,"change",({valueAsNumber:s})=>this._setLight(i,s,!1))};t("environment-intensity","strength"),t("sun-intensity","sun"),t("sun-height","sunHeight"),t("rotation","rotation"),ue("environment","change",({value:r})=>this._setLight("choice",r,!1)),ue("exposure","input",({valueAsNumber:r})=>e.setExposure(r)),ue("exposure","change",()=>this.hasGround&&e.changed()),ue("view-transform","change",({value:r})=>e.setView(r)),ue("denoise","change",({checked:r})=>e.setDenoise(r)),ue("ground","change",()=>e.changed()),ue("faster","click",()=>e.switchTier(this.faster)),ue("reset","click",()=>e.resetView()),ue("screenshot","click",()=>this._save()),ue("fullscreen","click",()=>this._fullScreen()),this.showLighting(e.lighting),this.showExposure(0)}_setLight(e,t,r){(e==="sun"||e==="sunHeight")&&(this.app.lighting.suns=null),this.app.lighting[e]=t,this.showLighting(this.app.lighting),this.app.changed(r)}get hasGround(){return Q("ground").checked}setGround(e){Q("ground").checked=e}showLighting({images:e,choice:t,strength:r,sun:i,suns:s,sunHeight:a,rotation:c}){let l=[...e].map(([h,{label:p}])=>new Option(p,h,!1,h===t));Q("environment").replaceChildren(...l),ut("environment-intensity",r,r.toFixed(2)),ut("sun-intensity",i,s?"the scene's":i.toFixed(1)),ut("sun-height",a,s?"the scene's":`${wn(Math.round(a),0)}\xB0`),ut("rotation",c,`${wn(Math.round(c),0)}\xB0`)}showExposure(e){ut("exposure",e,`${wn(e,1)} stops`)}showView(e){Q("view-transform").value=e}showEngine(e,t){Q("api").textContent=[e,...t].join(": ")}showPackage({manifest:e,warnings:t=e.warnings,bytesOf:r,...i},{tier:s}){let a=this.app.opened;document.title=`${e.name} \u2013 RNA viewer`,Q("name").textContent=e.name,Q("tier").replaceChildren(...e.tiers.map(({name:h})=>new Option(h,h,!1,h===s.name)));let{validation:c,cost:l}=s;Q("error").textContent=c?`${c.psnr.toFixed(1)} dB, FLIP ${c.flip.toFixed(3)}`:"not recorded",Q("cost").textContent=l?`${l.multiplyAdds.toLocaleString("en")} multiply-adds`:"not recorded",Q("size").textContent=qe(a.bytesOf(s.name)),t.length&&Ae(t.join("; "),!0,"asset")}showStats({ms:e,rounds:t,scale:r}){Q("time").textContent=e?fr(e):"\u2013",Q("rounds").textContent=r===1?String(t):`first look, 1/${r} of the size`,this._suggestTier(e)}_suggestTier(e){let{opened:t,shown:r}=this.app,i=r?.tier.cost?.multiplyAdds,s=({cost:l})=>e*l.multiplyAdds/i,a=i&&e>So?t.manifest.tiers.filter(({cost:l})=>l&&l.multiplyAdds<Du*i).sort((l,h)=>s(h)-s(l)):[],c=a.find(l=>s(l)<=So)??a.at(-1);this.faster=c?.name,Q("faster").hidden=!c,c&&(Q("faster").textContent=`Switch to tier ${c.name}: about ${fr(s(c))} a sample`)}showProgress(e,t){if(Q("loading").hidden=e===null,e===null)return;let r=Q("bar");t?Object.assign(r,{max:Math.max(t,e),value:e}):r.removeAttribute("value"),Q("bytes").textContent=t?`${qe(e)} of ${qe(Math.max(t,e))}`:qe(e)}showPoster(e){let t=Q("poster");t.src&&URL.revokeObjectURL(t.src),t.hidden=!e,e?t.src=URL.createObjectURL(e):t.removeAttribute("src")}async _save(){let{viewer:e}=this.app,t=Q("screenshot");if(!e)return;if(this.saving)return this.saving.abort();let r=this.saving=new AbortController,i=()=>{let{rounds:a,scale:c}=e.stats;t.textContent=`Save now (${c===1?a:0} of ${e.rounds})`};i(),e.addEventListener("shown",i),await Promise.race([e.converged(),new Promise(a=>r.signal.addEventListener("abort",a))]),e.removeEventListener("shown",i),this.saving=null,t.textContent="Save picture";let s=document.createElement("a");s.href=URL.createObjectURL(await this.app.screenshot()),s.download=`${this.app.opened?.manifest.name??"rna"}.png`,s.click(),setTimeout(()=>URL.revokeObjectURL(s.href),1e3)}_fullScreen(){document.fullscreenElement?document.exitFullscreen():document.documentElement.requestFullscreen?.()}};var To=(n,e)=>n.reduce((t,r,i)=>t+r*e[i],0),Uu=[[.59719,.35458,.04823],[.076,.90834,.01566],[.0284,.13383,.83777]],Bu=[[1.60475,-.53108,-.07367],[-.10208,1.10813,-.00605],[-.00327,-.07276,1.07602]];function $u(n){let e=Uu.map(t=>{let r=1.461926*To(t,n);return(r*(r+.0245786)-90537e-9)/(r*(.983729*r+.432951)+.238081)});return Bu.map(t=>To(t,e))}function No(n){let e=[...n];for(let t=0;t<60;t++){let r=$u(e);e=e.map((i,s)=>i*Math.min(2,Math.max(.5,n[s]/Math.max(r[s],1e-6))))}return e}var Hu={kind:"sun",direction:[0,1,0],colour:[0,0,0]},er=[.052,.056,.063],Qn=class extends EventTarget{constructor(e,t,r){super(),Object.assign(this,{engine:e,canvas:t,orbit:r}),Object.assign(this,{lights:[],ground:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,generation:0,msPerPixel:.005,shown:null,finest:1,ready:!1,stopped:!1,moving:!1,stats:{ms:0,rounds:0}}),this.wake=null}restart(e=!1){this.moving=e,Object.assign(this.stats,{rounds:0,scale:0}),this.generation+=1,this.wake?.()}start(){this.ready=!0,this.running??=this._run(),this.restart()}pause(){this.ready=!1,this.generation+=1}stop(){return this.stopped=!0,this.pause(),this.wake?.(),this.running}async converged(e=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=e);)await new Promise(t=>this.addEventListener("shown",t,{once:!0}))}show(){if(!this.shown)return;let{rounds:e}=this.shown,t=this.denoise&&e<12;this.engine.show({rounds:e,exposure:2**this.exposure,backdrop:er,filmic:this.view==="filmic",spread:t?.4/Math.sqrt(e):0})}async _run(){for(;!this.stopped;){let e=this.generation;try{this.ready&&await this._picture(e)}catch(t){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:t})),this.ready=!1}e===this.generation&&!this.stopped&&await new Promise(t=>{this.wake=t})}}async _picture(e){for(let t of this._scales()){let r=t===1&&!this.moving?this.rounds:1;if(!await this._stage(e,t,r)||this.moving)return}}_scales(){let e=this.canvas.width*this.canvas.height*Math.max(1,this.lights.length),t=1;for(;t<16&&e*this.msPerPixel/t**2>110;)t*=2;let r=[t];for(;t>1;)r.push(t=t>4?t/4:1);return r}async _stage(e,t,r){let{engine:i,canvas:s}=this,a=Math.ceil(s.width/t),c=Math.ceil(s.height/t);this.shown=null,i.resize(a,c);let l={...this.orbit.camera(a,c),jitter:this.jitter};if(!this.hasShown){if(!await this._round(e,l,0,this.lights.slice(0,1)))return!1;this._present(1,t)}for(let h=0;h<r;h++){let p=performance.now();if(!await this._round(e,l,h,this.lights))return!1;this._present(h+1,t),this._measure(performance.now()-p,a*c,t)}return!0}async _round(e,t,r,i){let{engine:s}=this,{width:a,height:c}=s.target,l=this.msPerPixel*a*Math.max(1,i.length),h=Math.max(1,Math.min(c,Math.floor(120/l),Math.floor(s.bandPixels/a)));for(let p=0;p<c;p+=h)if(this._band(t,r,i,p,Math.min(c,p+h)),await s.done(),e!==this.generation||this.stopped||s.lost)return!1;return!0}_band(e,t,r,i,s){let{engine:a}=this;a.trace(e,t,i,s),(r.length?r:[Hu]).forEach((l,h)=>a.light({...l,ground:this.ground},{isFirst:t===0&&h===0,countsCoverage:h===0})),a.emits&&a.emission()}_present(e,t){this.shown={rounds:e},this.show(),this.hasShown||performance.mark("picture"),this.hasShown=!0,Object.assign(this.stats,{rounds:e,scale:t}),this.dispatchEvent(new Event("shown"))}_measure(e,t,r){let i=e/(t*Math.max(1,this.lights.length));this.msPerPixel=t<4096?Math.min(this.msPerPixel*4,i):.5*(this.msPerPixel+i),r===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*e:e)}};var Gu=22e5,tr=class{constructor(e,t={}){Object.assign(this,{parameters:e,labels:t,orbit:new Vn,lighting:new Wn,opened:null,loading:null}),this.panel=new Jn(this),this.places={view:document.getElementById("view")},new ResizeObserver(()=>this.resize()).observe(this.places.view),this._listenForDrops()}begin(){return this.begun=this._begin(),this.begun.catch(e=>this._failed(e,"engine")),this.begun}async _begin(){let e=()=>Object.assign(document.createElement("canvas"),{tabIndex:0,role:"application",ariaLabel:"The asset. Arrow keys orbit."}),{engine:t,canvas:r,reasons:i}=await Js(e,this.parameters.get("api"));Object.assign(this,{engine:t,canvas:r}),r.setAttribute("aria-describedby","keys"),this.places.view.replaceChildren(r),t.onlost=s=>this._recover(s),this.viewer=new Qn(t,r,this.orbit),this.parameters.has("rounds")&&(this.viewer.rounds=Number(this.parameters.get("rounds"))),this.parameters.get("jitter")==="0"&&(this.viewer.jitter=0),this.parameters.has("view")&&this.setView(this.parameters.get("view")),this.viewer.addEventListener("shown",()=>this.panel.showStats(this.viewer.stats)),this.viewer.addEventListener("failed",({error:s})=>this._failed(s,"asset")),performance.mark("engine"),xo(r,this._actions()),this.panel.showEngine(t.constructor.label,i),this.resize()}expectAsset(e=!0){document.body.classList.toggle("expecting",e)}async open(e){this.loading?.abort();let t=this.loading=new AbortController;this.expectAsset();try{Ae(null,!1,"asset");let r=e instanceof Blob?new lt(e,e.name):await yn.open(e,(s,a)=>this.panel.showProgress(s,a),t.signal,this.labels[e]),i=await _t.open(r);if(t.signal.aborted)return;await this._showPoster(i),await this._show(i,this.parameters.get("tier"),!0)}catch(r){!t.signal.aborted&&r.name!=="AbortError"&&this._failed(r,"asset")}finally{this.loading===t&&(this.panel.showProgress(null),this.expectAsset(!1))}}async switchTier(e){try{Ae(null,!1,"asset"),await this._show(this.opened,e,!1)}catch(t){this._failed(t,"asset")}finally{this.panel.showProgress(null)}}async openScene(e){try{let t=JSON.parse(new TextDecoder().decode(await ri(e))),{radiance:r,image:i}=t.environment??{};if(r&&(t.environment.key=this.lighting.add("The scene's",Bn(r))),i){let s=this.labels[i]??i;t.environment.key=this.lighting.add(s,ti(await ri(tn(i)),i))}return await this.begun,this.applyScene(t),t}catch(t){return this._failed(t,"scene"),null}}async openImage(e,t){try{Ae(null,!1,"light");let r=e instanceof Blob?await e.arrayBuffer():await ri(e);this.lighting.choice=this.lighting.add(this.labels[t]??t,ti(r,t)),this.panel.showLighting(this.lighting),this.changed()}catch(r){this._failed(r,"light")}}changed(e=!1){if(!this.viewer)return;let{lights:t,irradiance:r}=this.lighting.lights();t.some(({kind:i})=>i==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded)),this.viewer.lights=t,this.viewer.ground=this._ground(r),this.viewer.restart(e)}resetView(){this.lighting.reset(),this.orbit=this.viewer.orbit=Object.assign(this.orbit,{azimuth:.6,elevation:.35,fov:30}),this.box&&this.orbit.frame(this.box,this.canvas.width/this.canvas.height),this.sceneView&&this.applyScene(this.sceneView),this.panel.showLighting(this.lighting),this.changed()}applyScene({camera:e,suns:t,environment:r,ground:i,exposure:s,view:a}){this.sceneView={camera:e,suns:t,environment:r,ground:i,exposure:s,view:a},e&&this.orbit.lookFrom(e.position,e.look_at,e.vertical_fov_deg),t&&(this.lighting.suns=t),r&&(this.lighting.choice=r.key??this.lighting.choice,this.lighting.strength=r.strength??1,this.lighting.imageTurn=r.rotation_deg??0),i!==void 0&&this.panel.setGround(i),s!==void 0&&this.setExposure(s),a&&!this.parameters.has("view")&&this.setView(a),this.panel.showLighting(this.lighting),this.changed()}setExposure(e){this.viewer&&(this.viewer.exposure=e,this.panel.showExposure(e),this.viewer.show())}setView(e){this.viewer&&(this.viewer.view=e,this.panel.showView(e),this.viewer.ground&&this.changed(),this.viewer.show())}setDenoise(e){this.viewer.denoise=e,this.viewer.show()}resize(){if(!this.viewer)return;let{clientWidth:e,clientHeight:t}=this.places.view,r=Number(this.parameters.get("dpr"))||Math.min(devicePixelRatio,2),i=Math.min(r,Math.sqrt(Gu/Math.max(1,e*t))),s=Math.max(1,Math.round(e*i)),a=Math.max(1,Math.round(t*i));this.canvas.width===s&&this.canvas.height===a||(Object.assign(this.canvas,{width:s,height:a}),this.viewer.restart())}get wgsl(){return{compose:Cn,sharedFiles:At,rayKernels:Ln}}reader(){return this.viewer.pause(),new Sn(this.engine)}screenshot(){return this.viewer.show(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}async _show(e,t,r){let i=await e.load(t);e.forget(),performance.mark("package"),await this.begun,r&&(this.viewer.hasShown=!1),this.viewer.pause();let s=r?xn(i.parts):this.arrays;performance.mark("hierarchy"),await this.engine.setAsset(s,i.parts),performance.mark("asset"),Object.assign(this,{opened:e,shown:i,arrays:s,box:s.box}),r&&this.orbit.frame(this.box,this.canvas.width/this.canvas.height),r&&this.sceneView&&this.applyScene(this.sceneView),document.body.classList.add("loaded"),this.panel.showPackage(e,i),this.viewer.stats.ms=0,this.changed(),this.viewer.start(),this.viewer.addEventListener("shown",()=>this.panel.showPoster(null),{once:!0})}async _showPoster(e){try{this.panel.showPoster(await e.posterImage())}catch{}}_ground(e){if(!this.panel.hasGround||!this.box)return null;let t=this.viewer.view==="filmic"?No(er):er,{min:r,max:i}=this.box,s=Math.hypot(...i.map((a,c)=>a-r[c]));return{height:r[1]-1e-4*s,x:(r[0]+i[0])/2,z:(r[2]+i[2])/2,size:2*s,colour:t.map((a,c)=>e[c]>0?a/e[c]/2**this.viewer.exposure:0)}}_actions(){let e=t=>(...r)=>{t(...r),this.viewer.restart(r.at(-1)===!0)};return{orbit:e((t,r)=>this.orbit.turn(t,r)),pan:e((t,r)=>this.orbit.pan(t,r)),zoom:e(t=>this.orbit.zoom(t)),light:(t,r,i)=>{this.lighting.rotation=yi(this.lighting.rotation+t*180/Math.PI),this.lighting.sunHeight=vi(this.lighting.sunHeight+r*180/Math.PI,-10,90),this.panel.showLighting(this.lighting),this.changed(i===!0)},settle:()=>this.viewer.moving&&this.viewer.restart(),reset:()=>this.resetView()}}_listenForDrops(){let e=document.body;for(let t of["dragenter","dragover"])addEventListener(t,r=>{r.preventDefault(),e.classList.add("dropping")});addEventListener("dragleave",()=>e.classList.remove("dropping")),addEventListener("drop",async t=>{t.preventDefault(),e.classList.remove("dropping");for(let r of[...t.dataTransfer?.files??[]])await this.openFile(r)})}openFile(e){return/\.(hdr|pic|exr)$/i.test(e.name)?this.openImage(e,e.name):this.open(e)}async _recover(e){let{shown:t,arrays:r}=this;Ae(`${e}; starting again`,!0,"engine"),this.viewer?.stop(),this.uploaded=null;try{let{exposure:i,rounds:s,view:a,denoise:c}=this.viewer;await this.begin(),this.viewer.hasShown=!0,Object.assign(this.viewer,{exposure:i,rounds:s,view:a,denoise:c}),t&&(await this.engine.setAsset(r,t.parts),this.changed(),this.viewer.start()),Ae(null,!1,"engine")}catch(i){this._failed(i,"engine")}}_failed(e,t="page"){let r=e instanceof Lt||e instanceof B;r||console.error(e),Ae(r?e.message:`this did not work: ${e.message??e}`,!1,t),this.failures=(this.failures??0)+1}};async function ri(n){let e=await fetch(n).catch(()=>null);if(!e?.ok)throw new B(`cannot load ${n}${e?`: HTTP ${e.status}`:""}`);return e.arrayBuffer()}var qu=5,Zu=400;function Oo({bounds:{min:n,max:e}},t){let r=new Float32Array(16*t),i=1,s=()=>(i=Math.imul(i,1664525)+1013904223>>>0)/2**32,a=()=>{let c=2*s()-1,l=2*Math.PI*s(),h=Math.sqrt(1-c*c);return[h*Math.cos(l),h*Math.sin(l),c]};for(let c=0;c<t;c++){let l=n.map((h,p)=>h+s()*(e[p]-h));r.set([...l,0,...a(),0,...a(),0,...a(),0],16*c)}return r}var ju=n=>[...n].sort((e,t)=>e-t)[Math.floor(n.length/2)];async function Wu(n,e,t=0){let{evaluate:r}=n.constructor.label==="WebGPU"?Zt:Ht,i=1024,s=0;for(;;){let l=Oo(e[t],i),h=performance.now();if(await r(n,t,"transport",l,!1),s=performance.now()-h,s>Zu/2||i>=n.bandPixels)break;i*=2}let a=Oo(e[t],i),c=[];for(let l=0;l<qu;l++){let h=performance.now();await r(n,t,"transport",a,!1),c.push(i/(performance.now()-h)/1e3)}return{rate:ju(c),count:i}}function Yu({transport:n,planes:e}){let t=n.layers.reduce((i,{rows:s,columns:a})=>i+s*a,0),r=12*e.channels*{float16:2,float32:4,int8:1}[e.precision];return{multiplyAdds:t,bytes:r}}async function Vu(n){let e=n.device?.adapterInfo;if(e)return[e.vendor,e.architecture,e.description].filter(Boolean).join(" ");let t=n.gl,r=t?.getExtension("WEBGL_debug_renderer_info");return r?t.getParameter(r.UNMASKED_RENDERER_WEBGL):"unknown"}async function Io(n){let{viewer:e,engine:t,shown:r,opened:i}=n;if(!r)return;let s=3;e.rounds=s,e.restart(),await e.converged(s);let a=n.canvas.width*n.canvas.height,c=e.stats.ms;e.pause(),await t.done();let{rate:l,count:h}=await Wu(t,r.parts),{multiplyAdds:p,bytes:m}=Yu(r.parts[0]),v={asset:i.manifest.name,tier:r.name,api:t.constructor.label,gpu:await Vu(t),millionQueriesPerSecond:Number(l.toPrecision(3)),queries:h,multiplyAddsPerQuery:p,planeBytesPerQuery:m,picture:`${n.canvas.width} x ${n.canvas.height}`,lights:e.lights.length,msPerSample:Math.round(c),megapixelsPerSecond:Number((a/c/1e3).toPrecision(3)),browser:navigator.userAgent};Xu(v),n.viewer.start(),globalThis.rnaBenchmark=v}function Xu(n){let e=document.getElementById("bench");e.replaceChildren();for(let[t,r]of[...Object.entries(n),["line to send in",JSON.stringify(n)]]){let i=e.insertRow();i.insertCell().textContent=t,i.insertCell().textContent=String(r)}e.hidden=!1}async function Ku(){let{query:n,labels:e}=document.body.dataset,{parameters:t,problems:r}=ko(n,location.search);Ae(r.join("; "),!0,"address"),document.body.classList.toggle("bare",t.get("ui")==="0");let i=globalThis.rnaViewer=new tr(t,JSON.parse(e??"{}"));i.begin();let s=m=>t.has(m)?tn(t.get(m)):null,a=s("asset"),c=s("scene"),l=s("env");a&&i.expectAsset();let h=c&&await i.openScene(c);l&&await i.openImage(l,lr(l));let p=a??(h?.asset&&tn(h.asset));p&&await i.open(p),t.get("bench")==="1"&&await Io(i)}Ku();})();
/*! Bundled license information:

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
